// What /diagnostics says of MappingNode; see mapping_node.h.
#include "rovio_sfm/ros/mapping_node.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {

std::string MappingNode::RecentRefusal() const {
  for (const NewestRefusal* refused :
       {&frame_subscriber_.refused(), &unmapped_, &refused_matches_}) {
    const std::string reason = refused->RecentReason(SteadySeconds());
    if (!reason.empty()) return reason;
  }
  return "";
}

void MappingNode::SummarizeMaps(const MapPicture& picture,
                                diagnostic_updater::DiagnosticStatusWrapper* status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const auto& sessions = picture.snapshot->sessions;
  std::string astray;
  for (const std::string& robot : picture.astray) astray += " " + robot;
  if (!astray.empty()) {
    status->summary(Level::WARN, "not found in the map:" + astray);
  } else if (options_.localize) {
    status->summary(Level::OK, "robots are found in the map");
  } else if (!sessions.empty() && sessions.back().state == SessionState::kBootstrapping) {
    status->summary(Level::WARN, "the newest session looks for its first two frames");
  } else {
    status->summary(Level::OK, "frames are mapped");
  }
}

void MappingNode::Summarize(const MapPicture& picture,
                            diagnostic_updater::DiagnosticStatusWrapper* status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  if (!picture.store_error.empty()) {
    status->summary(Level::ERROR, "maps are not saved any more: " + picture.store_error);
  } else if (const std::string foreign = frame_subscriber_.foreign().RecentReason(SteadySeconds());
             !foreign.empty()) {
    status->summary(Level::ERROR, foreign);
  } else if (const std::string refusal = RecentRefusal(); !refusal.empty()) {
    status->summary(Level::WARN, refusal);
  } else if (picture.num_events == 0) {
    status->summary(Level::WARN, "no frames yet");
  } else if (!frame_subscriber_.HasSenders()) {
    status->summary(Level::WARN, "no frontend runs any more");
  } else {
    SummarizeMaps(picture, status);
  }
}

void MappingNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const MapPicture picture = engine_.Picture();
  const IngestCounters counters = Counters();
  Summarize(picture, &status);
  status.add("events", picture.num_events);
  status.add("events queued", worker_.NumQueued(kFrameLane));
  status.add("events held, missing ones are fetched", num_held_.load());
  status.add("events dropped, queue full", counters.dropped);
  status.add("events refused", counters.refused + picture.counters.refused_events);
  status.add("events refused, foreign sender", frame_subscriber_.foreign().Count());
  status.add("newest malformed event", frame_subscriber_.refused().Reason());
  status.add("newest event refused by the mapper", unmapped_.Reason());
  status.add("newest place match refused", refused_matches_.Reason());
  status.add("events missing", picture.counters.missing_events);
  status.add("gaps lost, frontend silent", counters.lost_gaps);
  status.add("place matches", picture.num_place_matches);
  status.add("place matches waiting", picture.num_matches_waiting);
  status.add("place matches repeated", picture.num_matches_repeated);
  status.add("place matches refused", counters.refused_matches);
  status.add("place matches queued", worker_.NumQueued(kMatchLane));
  status.add("place matches dropped, queue full", counters.dropped_matches);
  status.add("overlaps judged", picture.merges->size());
  status.add("sessions", picture.snapshot->sessions.size());
  status.add("sessions lost", picture.counters.lost_sessions);
  status.add("keyframes", picture.counters.keyframes);
  status.add("light frames", picture.counters.light_frames);
  status.add("frames localized", picture.num_localized);
  status.add("frames not localized", picture.num_not_localized);
}

}  // namespace rovio_sfm
