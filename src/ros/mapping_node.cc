#include "rovio_sfm/ros/mapping_node.h"

#include <future>
#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/export_map.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr size_t kHistoryEvents = 100000;
constexpr size_t kHistoryBytes = 256u << 20;
constexpr double kEdgePeriodS = 0.05;
constexpr double kMapPeriodS = 0.25;
constexpr double kWarnPeriodS = 10.0;
constexpr uint32_t kFetchPage = 20;      // events of one call
constexpr uint32_t kServiceThreads = 2;  // one call may wait for the worker, another answer

double SteadySeconds() { return ros::SteadyTime::now().toSec(); }

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
      worker_(kJobQueue, WhenFull::kDropOldest, [](const Job& job) { job(); }) {
  diagnostics_.setHardwareID("none");
  diagnostics_.add("frames to maps", this, &MappingNode::Diagnose);
  AdvertiseServices();
  SubscribeFrames();
  edge_timer_ = node_.createWallTimer(
      ros::WallDuration(kEdgePeriodS),
      [this](const ros::WallTimerEvent&) { publisher_.PublishEdges(engine_.Picture()); });
  map_timer_ =
      node_.createWallTimer(ros::WallDuration(kMapPeriodS), [this](const ros::WallTimerEvent&) {
        publisher_.PublishMap(engine_.Picture(), Counters(), false);
      });
  service_spinner_.start();
}

MappingNode::~MappingNode() {
  subscribers_.clear();
  service_spinner_.stop();
  ROS_INFO_STREAM("ending: " << worker_.NumQueued() << " events are still queued");
  give_up_s_ = SteadySeconds() + options_.drain_s;
  worker_.Finish();
  if (num_given_up_ > 0) ROS_WARN_STREAM(num_given_up_ << " queued events were not mapped");
  engine_.Finish();
  publisher_.PublishMap(engine_.Picture(), Counters(), true);
  if (!options_.output_dir.empty()) WriteFinalMap();
}

void MappingNode::SubscribeFrames() {
  for (const std::string& robot : options_.robots) {
    const std::string prefix = "/" + robot + "/";
    frontends_[robot] = node_.serviceClient<rovio_sfm::GetFrames>(prefix + topics::kGetFrames);
    const boost::function<void(const FrameEventMsg::ConstPtr&)> handle =
        [this, robot](const FrameEventMsg::ConstPtr& message) { OnFrame(robot, message); };
    subscribers_.push_back(
        node_.subscribe<FrameEventMsg>(prefix + topics::kFrames, topics::kFramesQueue, handle));
  }
}

void MappingNode::OnFrame(const std::string& robot, const FrameEventMsg::ConstPtr& message) {
  std::string error;
  std::optional<FrameEvent> event = FromMessage(*message, &error);
  if (!event) return Refuse("frame of " + robot + " refused: " + error);
  if (event->id.drive.robot != robot) {
    return Refuse("frame on /" + robot + "/frames refused: it says that its robot is " +
                  event->id.drive.robot);
  }
  worker_.Push([this, message, event = std::move(*event)] {
    if (give_up_s_ > 0.0 && SteadySeconds() > give_up_s_) {
      ++num_given_up_;
    } else {
      Ingest(message, event);
    }
  });
}

void MappingNode::Refuse(const std::string& reason) {
  ++num_refused_;
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, reason);
}

IngestCounters MappingNode::Counters() const {
  return {num_refused_, worker_.NumDropped() + num_given_up_};
}

void MappingNode::Ingest(const FrameEventMsg::ConstPtr& message, const FrameEvent& event) {
  FetchMissing(event.id);
  Map(message, event);
}

// Asks the frontend for what lies between the last event and this one; what it no longer has stays
// missing, and the mapper counts it.
void MappingNode::FetchMissing(const FrameId& id) {
  GetFramesRequest request;
  GetFramesResponse response;
  for (uint32_t next = engine_.NextIndex(id); next < id.index; next = response.next_index) {
    request.first = ToMessage(FrameId{id.drive, next});
    request.max_frames = kFetchPage;
    if (!frontends_[id.drive.robot].call(request, response)) return;
    for (const FrameEventMsg& frame : response.frames) {
      std::string error;
      const std::optional<FrameEvent> event = FromMessage(frame, &error);
      if (event && event->id.drive == id.drive && event->id.index < id.index) {
        Map(boost::make_shared<FrameEventMsg>(frame), *event);
      }
    }
    if (!response.more || response.next_index <= next) return;
  }
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
