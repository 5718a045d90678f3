#include "rovio_sfm/ros/mapping_node.h"

#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/export_map.h"
#include "rovio_sfm/ros/fetch_frames.h"
#include "rovio_sfm/ros/place_match_message.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr size_t kHistoryEvents = 100000;
constexpr size_t kHistoryBytes = 256u << 20;
constexpr double kEdgePeriodS = 0.05;
constexpr double kMapPeriodS = 0.25;
constexpr double kWarnPeriodS = 10.0;
constexpr uint32_t kServiceThreads = 2;  // one call may wait for the worker, another answer

}  // namespace

MappingNode::MappingNode(const MappingNodeOptions& options, ros::NodeHandle node,
                         ros::NodeHandle private_node)
    : options_(options),
      node_(node),
      engine_(options.mapper),
      publisher_(node, options.cloud_period_s),
      history_(kHistoryEvents, kHistoryBytes),
      service_spinner_(kServiceThreads, &service_queue_),
      diagnostics_(node, private_node),
      worker_(kJobQueue, WhenFull::kDropOldest, [](const Job& job) { job(); }),
      frame_subscriber_(
          node_, options.robots,
          [this](const FrameEventMsg::ConstPtr& message, FrameEvent event) {
            Push([this, message, event = std::move(event)] { Ingest(message, event); });
          }),
      match_subscriber_(node_.subscribe(topics::kPlaceMatches, topics::kPlaceMatchesQueue,
                                        &MappingNode::OnPlaceMatch, this)) {
  for (const std::string& robot : options_.robots) {
    frontends_[robot] =
        node_.serviceClient<rovio_sfm::GetFrames>("/" + robot + "/" + topics::kGetFrames);
  }
  diagnostics_.setHardwareID("none");
  diagnostics_.add("frames to maps", this, &MappingNode::Diagnose);
  AdvertiseServices();
  edge_timer_ =
      node_.createWallTimer(ros::WallDuration(kEdgePeriodS), [this](const ros::WallTimerEvent&) {
        publisher_.PublishEdges(engine_.Picture(), Counters());
      });
  map_timer_ =
      node_.createWallTimer(ros::WallDuration(kMapPeriodS), [this](const ros::WallTimerEvent&) {
        publisher_.PublishMap(engine_.Picture(), Counters(), false);
      });
  service_spinner_.start();
}

MappingNode::~MappingNode() {
  frame_subscriber_.Stop();
  match_subscriber_.shutdown();
  service_spinner_.stop();
  ROS_INFO_STREAM("ending: " << worker_.NumQueued() << " events are still queued");
  give_up_s_ = SteadySeconds() + options_.drain_s;
  worker_.Finish();
  if (num_given_up_ > 0) ROS_WARN_STREAM(num_given_up_ << " queued events were not mapped");
  engine_.Finish();
  publisher_.PublishMap(engine_.Picture(), Counters(), true);
  if (!options_.output_dir.empty()) WriteFinalMap();
}

void MappingNode::OnPlaceMatch(const PlaceMatchMsg::ConstPtr& message) {
  std::string error;
  std::optional<PlaceMatch> match = FromMessage(*message, &error);
  if (match) return Push([this, match = std::move(*match)] { engine_.Add(match); });
  ++num_refused_matches_;
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, "place match refused: " << error);
}

void MappingNode::Push(Job job) {
  worker_.Push([this, job = std::move(job)] {
    if (give_up_s_ > 0.0 && SteadySeconds() > give_up_s_) {
      ++num_given_up_;
    } else {
      job();
    }
  });
}

IngestCounters MappingNode::Counters() const {
  return {frame_subscriber_.NumRefused(), worker_.NumDropped() + num_given_up_,
          num_refused_matches_};
}

void MappingNode::Ingest(const FrameEventMsg::ConstPtr& message, const FrameEvent& event) {
  FetchMissing(event.id);
  Map(message, event);
}

// Asks the frontend for what lies between the last event and this one; what it no longer has stays
// missing, and the mapper counts it.
void MappingNode::FetchMissing(const FrameId& id) {
  const uint32_t next = engine_.NextIndex(id);
  if (next >= id.index) return;
  ros::ServiceClient& frontend = frontends_[id.drive.robot];
  FetchFrames([&](auto& request, auto& response) { return frontend.call(request, response); },
              {id.drive, next}, id.index,
              [this](const FrameEventMsg& message, const FrameEvent& event) {
                Map(boost::make_shared<FrameEventMsg>(message), event);
              });
}

void MappingNode::Map(const FrameEventMsg::ConstPtr& message, const FrameEvent& event) {
  const MapperReport report = engine_.Add(event);
  if (report.outcome == MapperOutcome::kRefused) {
    ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, "frame refused: " << report.reason);
    return;
  }
  history_.Add(message);
  publisher_.PublishPose(engine_.Picture(), report.session, event.id.index);
}

void MappingNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const MapPicture picture = engine_.Picture();
  const IngestCounters counters = Counters();
  const auto& sessions = picture.snapshot->sessions;
  if (picture.num_events == 0) {
    status.summary(Level::WARN, "no frames yet");
  } else if (!sessions.empty() && sessions.back().state == SessionState::kBootstrapping) {
    status.summary(Level::WARN, "the newest session looks for its first two frames");
  } else {
    status.summary(Level::OK, "frames are mapped");
  }
  status.add("events", picture.num_events);
  status.add("events queued", worker_.NumQueued());
  status.add("events dropped, queue full", counters.dropped);
  status.add("events refused", counters.refused + picture.counters.refused_events);
  status.add("events missing", picture.counters.missing_events);
  status.add("place matches", picture.num_place_matches);
  status.add("place matches waiting", picture.num_matches_waiting);
  status.add("place matches repeated", picture.num_matches_repeated);
  status.add("place matches refused", counters.refused_matches);
  status.add("overlaps judged", picture.merges.size());
  status.add("sessions", sessions.size());
  status.add("sessions lost", picture.counters.lost_sessions);
  status.add("keyframes", picture.counters.keyframes);
  status.add("light frames", picture.counters.light_frames);
}

void MappingNode::WriteFinalMap() const {
  ExportMapRequest request;
  request.overwrite = options_.overwrite;
  ExportMapResponse response =
      ExportMapFiles(*engine_.Picture().snapshot, options_.output_dir, request);
  for (int i = 1; response.status.code == Status::ALREADY_EXISTS; ++i) {
    request.name = "map_" + std::to_string(i);  // an older map is never replaced unasked
    response = ExportMapFiles(*engine_.Picture().snapshot, options_.output_dir, request);
  }
  if (response.status.code == Status::OK) {
    for (const std::string& file : response.files) ROS_INFO_STREAM("wrote " << file);
  } else {
    ROS_ERROR_STREAM("map not written: " << response.status.message);
  }
}

}  // namespace rovio_sfm
