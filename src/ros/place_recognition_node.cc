#include "rovio_sfm/ros/place_recognition_node.h"

#include <rovio_sfm/ListSessions.h>

#include <limits>
#include <set>
#include <utility>

#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/place_match_message.h"
#include "rovio_sfm/ros/place_status_message.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr double kWarnPeriodS = 10.0;
constexpr size_t kBytesPerMb = 1u << 20;
constexpr size_t kMaxFrameBytes = 128u << 20;  // queued
constexpr size_t kMaxTold = 200;               // matches, some kB each
constexpr double kPauseS = 0.05;               // until mapping is asked again,
constexpr int kMaxPauses = 60;                 // at most so often for one gap
constexpr uint32_t kServiceThreads = 1;        // calls wait for the worker one after the other

// In the order of PlaceRecognitionNode::Lane. Frames dropped are counted, and fetched again; a call
// that is refused says so.
std::vector<LaneOptions> WorkerLanes() {
  return {{500, LaneFull::kDropOldest, kMaxFrameBytes}, {16, LaneFull::kRefuse}};
}

}  // namespace

PlaceRecognitionNode::PlaceRecognitionNode(const PlaceRecognitionNodeOptions& options,
                                           ros::NodeHandle node, ros::NodeHandle private_node)
    : options_(options),
      node_(node),
      cache_(static_cast<size_t>(options.cache_mb) * kBytesPerMb,
             [this](const FrameId& id) { return FetchFeatures(id); }),
      recognizer_(options.places, ReadPlaceModel(options.vocabulary), &cache_),
      match_publisher_(node_.advertise<PlaceMatchMsg>(
          topics::kPlaceMatches, topics::kPlaceMatchesQueue,
          [this](const ros::SingleSubscriberPublisher& subscriber) { TellAgain(subscriber); })),
      status_publisher_(
          node_.advertise<PlaceStatus>(topics::kPlaceStatus, topics::kPlaceStatusQueue, true)),
      mapping_frames_(node_.serviceClient<rovio_sfm::GetFrames>(topics::kGetFrames)),
      mapping_sessions_(node_.serviceClient<rovio_sfm::ListSessions>(topics::kListSessions)),
      service_spinner_(kServiceThreads, &service_queue_),
      diagnostics_(node, private_node),
      worker_(WorkerLanes(), [](const Job& job) { job(); }),
      subscriber_(node_, options.robots,
                  [this](const FrameEventMsg::ConstPtr& message, FrameEvent event) {
                    OnFrame(*message, std::move(event));
                  }) {
  for (const std::string& robot : options_.robots) {
    frontends_[robot] =
        node_.serviceClient<rovio_sfm::GetFrames>("/" + robot + "/" + topics::kGetFrames);
  }
  diagnostics_.setHardwareID("none");
  diagnostics_.add("frames to places", this, &PlaceRecognitionNode::Diagnose);
  worker_.Push(kCallLane, [this] { FetchKnownDrives(); });
  AdvertiseServices();
  service_spinner_.start();
}

PlaceRecognitionNode::~PlaceRecognitionNode() {
  subscriber_.Stop();
  service_spinner_.stop();
  const size_t num_forgotten = worker_.Stop();
  if (num_forgotten > 0)
    ROS_INFO_STREAM("ending: " << num_forgotten << " events were not looked at");
}

// Nobody here looks at the image: it is not kept.
void PlaceRecognitionNode::OnFrame(const FrameEventMsg& message, FrameEvent event) {
  event.jpeg.reset();
  const size_t num_bytes = ros::serialization::serializationLength(message) - message.jpeg.size();
  worker_.Push(
      kFrameLane, [this, event = std::move(event)] { Ingest(event); }, num_bytes);
}

// After a restart: all that mapping holds.
void PlaceRecognitionNode::FetchKnownDrives() {
  rovio_sfm::ListSessions sessions;
  if (!mapping_sessions_.exists() || !mapping_sessions_.call(sessions)) return;
  std::set<DriveId> drives;
  for (const SessionSummary& session : sessions.response.sessions) {
    std::string error;
    if (const auto drive = FromMessage(session.drive, &error)) drives.insert(*drive);
  }
  for (const DriveId& drive : drives) {
    FetchMissing({drive, std::numeric_limits<uint32_t>::max()});
  }
}

void PlaceRecognitionNode::Ingest(const FrameEvent& event) {
  const bool is_first = num_events_++ == 0;
  FetchMissing(event.id);
  Recognize(event);
  if (is_first) FetchKnownDrives();  // a drive may have ended while this node connected
}

// Asks mapping, which holds all that it has taken, then the frontend, which holds the newest, for
// what lies between the drive's last event and this one; then waits for mapping. What nobody has is
// counted, and stays missing.
void PlaceRecognitionNode::FetchMissing(const FrameId& id) {
  uint32_t next = next_indices_.try_emplace(id.drive, 0).first->second;
  const HandleFrame handle = [this](const FrameEventMsg&, const FrameEvent& event) {
    ++num_fetched_;
    Recognize(event);
  };
  const CallGetFrames mapping = [this](auto& request, auto& response) {
    return CallMapping(request, response);
  };
  if (next < id.index) next = FetchFrames(mapping, {id.drive, next}, id.index, handle);
  const auto frontend = frontends_.find(id.drive.robot);
  if (next < id.index && frontend != frontends_.end()) {
    next = FetchFrames(
        [&](auto& request, auto& response) { return frontend->second.call(request, response); },
        {id.drive, next}, id.index, handle);
  }
  int pauses = 0;
  const auto pause = [&pauses] {
    return ++pauses <= kMaxPauses && ros::WallDuration(kPauseS).sleep() && ros::ok();
  };
  FetchFramesOfFollower(mapping, {id.drive, next}, id.index, handle, pause);
}

bool PlaceRecognitionNode::CallMapping(GetFramesRequest& request, GetFramesResponse& response) {
  return mapping_frames_.exists() && mapping_frames_.call(request, response);
}

void PlaceRecognitionNode::Recognize(const FrameEvent& event) {
  uint32_t& next = next_indices_[event.id.drive];
  if (event.id.index < next) return;  // fetched before
  num_missing_ += event.id.index - next;
  next = event.id.index + 1;
  const double start_s = SteadySeconds();
  if (event.kind == FrameKind::kKeyframe) cache_.Put(event.id, event.features);
  Publish(recognizer_.Add(event), event.stamp_ns);
  PublishStatus(event.stamp_ns, SteadySeconds() - start_s);
}

// What the cache forgot.
std::shared_ptr<const FrameFeatures> PlaceRecognitionNode::FetchFeatures(const FrameId& id) {
  std::shared_ptr<const FrameFeatures> features;
  FetchFrames(
      [this](auto& request, auto& response) {
        request.max_frames = 1;
        return CallMapping(request, response);
      },
      id, id.index + 1,
      [&](const FrameEventMsg&, const FrameEvent& event) { features = event.features; });
  return features;
}

std::vector<PlaceMatch> PlaceRecognitionNode::Overlaps(const SessionSummary& a,
                                                       const SessionSummary& b,
                                                       size_t* num_compared) {
  const auto frames_of = [this](const SessionSummary& session) {
    std::string error;
    const std::optional<DriveId> drive = FromMessage(session.drive, &error);
    if (!drive) return std::vector<FrameId>{};
    return recognizer_.index().FramesBetween(*drive, session.first_index, session.last_index);
  };
  const std::vector<FrameId> others = frames_of(a), queries = frames_of(b);
  *num_compared = queries.size();
  return recognizer_.FindOverlaps(queries, others);
}

void PlaceRecognitionNode::Publish(const std::vector<PlaceMatch>& matches, int64_t stamp_ns) {
  MutexLock lock(mutex_);
  for (const PlaceMatch& match : matches) {
    told_.push_back(ToMessage(match, stamp_ns));
    if (told_.size() > kMaxTold) told_.pop_front();
    match_publisher_.publish(told_.back());
  }
}

void PlaceRecognitionNode::TellAgain(const ros::SingleSubscriberPublisher& subscriber) {
  MutexLock lock(mutex_);
  for (const PlaceMatchMsg& message : told_) subscriber.publish(message);
}

void PlaceRecognitionNode::PublishStatus(int64_t stamp_ns, double query_s) {
  PlaceStatus status = ToMessage(recognizer_.counters());
  status.header.stamp = ToTime(stamp_ns);
  status.vocabulary = options_.vocabulary;
  status.last_refusal = recognizer_.last_refusal();
  status.num_events = num_events_;
  status.num_refused = subscriber_.refused().Count() + recognizer_.counters().out_of_order;
  status.num_dropped = worker_.NumDropped(kFrameLane);
  status.num_fetched = num_fetched_;
  status.num_missing = num_missing_;
  status.num_drives = static_cast<uint32_t>(recognizer_.index().NumDrives());
  status.num_places = recognizer_.index().NumPlaces();
  status.index_bytes = recognizer_.index().NumBytes();
  status.last_query_s = query_s;
  status_publisher_.publish(status);
  MutexLock lock(mutex_);
  status_ = std::move(status);
}

PlaceStatus PlaceRecognitionNode::LastStatus() const {
  MutexLock lock(mutex_);
  return status_;
}

void PlaceRecognitionNode::Tick() {
  const PlaceStatus last = LastStatus();
  const bool has_frames = last.num_events + last.num_fetched > 0;
  hints_.Look(has_frames ? std::vector<AwaitedTopic>{} : AwaitedFrames(options_.robots),
              SteadySeconds());
  pace_.Tick();
}

void PlaceRecognitionNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const PlaceStatus last = LastStatus();
  const std::string foreign = subscriber_.foreign().RecentReason(SteadySeconds());
  const std::string refused = subscriber_.refused().RecentReason(SteadySeconds());
  if (!foreign.empty()) {
    status.summary(Level::ERROR, foreign);
  } else if (!refused.empty()) {
    status.summary(Level::WARN, refused);
  } else if (last.num_events + last.num_fetched == 0) {
    status.summary(Level::WARN, "no frames yet");
  } else if (last.num_foreign_type > 0) {
    status.summary(Level::WARN, "keyframes refused: " + last.last_refusal);
  } else {
    status.summary(Level::OK, "places are recognised");
  }
  status.add("events", last.num_events);
  status.add("events queued", worker_.NumQueued(kFrameLane));
  status.add("events dropped, queue full", worker_.NumDropped(kFrameLane));
  status.add("events refused", subscriber_.refused().Count());
  status.add("events refused, foreign sender", subscriber_.foreign().Count());
  status.add("newest event refused", subscriber_.refused().Reason());
  status.add("newest keyframe refused", last.last_refusal);
  status.add("events fetched", last.num_fetched);
  status.add("events missing", last.num_missing);
  status.add("places", last.num_places);
  status.add("queries", last.num_queries);
  status.add("queries matched", last.num_matched_queries);
  status.add("last query, s", last.last_query_s);
}

}  // namespace rovio_sfm
