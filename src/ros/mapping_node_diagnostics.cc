// What /diagnostics says of MappingNode; see mapping_node.h.
#include "rovio_sfm/ros/mapping_node.h"

namespace rovio_sfm {

void MappingNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const MapPicture picture = engine_.Picture();
  const IngestCounters counters = Counters();
  const auto& sessions = picture.snapshot->sessions;
  const std::string foreign = frame_subscriber_.ForeignSender();
  if (!picture.store_error.empty()) {
    status.summary(Level::ERROR, "maps are not saved any more: " + picture.store_error);
  } else if (!foreign.empty()) {
    status.summary(Level::ERROR, foreign);
  } else if (picture.num_events == 0) {
    status.summary(Level::WARN, "no frames yet");
  } else if (!sessions.empty() && sessions.back().state == SessionState::kBootstrapping) {
    status.summary(Level::WARN, "the newest session looks for its first two frames");
  } else {
    status.summary(Level::OK, "frames are mapped");
  }
  status.add("events", picture.num_events);
  status.add("events queued", worker_.NumQueued(kFrameLane));
  status.add("events held, missing ones are fetched", num_held_.load());
  status.add("events dropped, queue full", counters.dropped);
  status.add("events refused", counters.refused + picture.counters.refused_events);
  status.add("events refused, foreign sender", frame_subscriber_.NumForeign());
  status.add("events missing", picture.counters.missing_events);
  status.add("gaps lost, frontend silent", counters.lost_gaps);
  status.add("place matches", picture.num_place_matches);
  status.add("place matches waiting", picture.num_matches_waiting);
  status.add("place matches repeated", picture.num_matches_repeated);
  status.add("place matches refused", counters.refused_matches);
  status.add("place matches queued", worker_.NumQueued(kMatchLane));
  status.add("place matches dropped, queue full", counters.dropped_matches);
  status.add("overlaps judged", picture.merges->size());
  status.add("sessions", sessions.size());
  status.add("sessions lost", picture.counters.lost_sessions);
  status.add("keyframes", picture.counters.keyframes);
  status.add("light frames", picture.counters.light_frames);
}

}  // namespace rovio_sfm
