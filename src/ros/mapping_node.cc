#include "rovio_sfm/ros/mapping_node.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "rovio_sfm/app/wait_for_end.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/place_match_message.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxHeldFrames = 200;  // of a robot, while what is missing before them is fetched
constexpr size_t kMaxFrameBytes = 128u << 20;  // queued, and as much held
constexpr size_t kHistoryEvents = 100000;
constexpr size_t kHistoryBytes = 256u << 20;
constexpr double kEdgePeriodS = 0.05;
constexpr double kMapPeriodS = 0.25;
constexpr double kWarnPeriodS = 10.0;
constexpr double kSavePeriodS = 0.9;     // a crash costs less than a second
constexpr uint32_t kServiceThreads = 2;  // one call may wait for the worker, another answer

// In the order of MappingNode::Lane; no kind of work pushes out another. Frame events dropped are
// counted, and fetched from their frontend; place matches refused are counted, with a warning; who
// makes a call that is refused is told. Answers: one for each robot. The clock needs one.
std::vector<LaneOptions> WorkerLanes() {
  return {{500, LaneFull::kDropOldest, kMaxFrameBytes},
          {5000, LaneFull::kRefuse, 64u << 20},
          {16, LaneFull::kRefuse},
          {64, LaneFull::kRefuse},
          {1, LaneFull::kRefuse}};
}

// What it takes in memory, about. A frame: its message and its event, which has no image.
size_t SizeOf(const FrameEventMsg& message) {
  return 2 * ros::serialization::serializationLength(message) - message.jpeg.size();
}

size_t SizeOf(const PlaceMatch& match) {
  size_t num_bytes = sizeof(PlaceMatch);
  for (const OverlapPair& pair : match.pairs) {
    num_bytes += sizeof(OverlapPair) + pair.inliers.size() * sizeof(FeatureMatch);
  }
  return num_bytes;
}

ros::NodeHandle WithQueue(ros::NodeHandle node, ros::CallbackQueue* queue) {
  node.setCallbackQueue(queue);
  return node;
}

std::unique_ptr<StoreFolder> OpenStore(const MappingNodeOptions& options) {
  if (options.localize) {
    return std::make_unique<StoreFolder>(options.output_dir, ExistingStore::kRead);
  }
  if (!options.keep_store || options.output_dir.empty()) return nullptr;
  MapStoreOptions store;
  store.keep_images = options.keep_images;
  const auto file = StoreFolder::FileIn(options.output_dir);
  if (std::filesystem::exists(file)) ROS_INFO_STREAM("going on with the maps of " << file.string());
  return std::make_unique<StoreFolder>(options.output_dir, ExistingStore::kResume, store);
}

}  // namespace

MappingNode::MappingNode(const MappingNodeOptions& options, ros::NodeHandle node,
                         ros::NodeHandle private_node)
    : options_(options),
      node_(node),
      engine_(options.mapper, OpenStore(options)),
      news_(engine_.Picture()),
      maps_(options.output_dir, options.overwrite),
      publisher_(node, options.cloud_period_s),
      history_(kHistoryEvents, kHistoryBytes),
      fetcher_(node,
               [this](const GapFetch& fetch, std::vector<FetchedFrame> frames) {
                 OnAnswer(fetch, std::move(frames));
               }),
      gap_filler_(
          {options.fetch_timeout_s, kMaxHeldFrames, kMaxFrameBytes},
          [this](const FrameId& id) { return engine_.NextIndex(id); },
          [this](const GapFetch& fetch) { fetcher_.Fetch(fetch); }),
      service_spinner_(kServiceThreads, &service_queue_),
      diagnostics_(node, private_node),
      worker_(WorkerLanes(), [](const Job& job) { job(); }),
      frame_subscriber_(node_, options.robots,
                        [this](const FrameEventMsg::ConstPtr& message, FrameEvent event) {
                          OnFrame(message, std::move(event));
                        }),
      match_subscriber_(node_.subscribe(topics::kPlaceMatches, topics::kPlaceMatchesQueue,
                                        &MappingNode::OnPlaceMatch, this)),
      finish_(WithQueue(node_, &service_queue_), SourcesOfActions()) {
  diagnostics_.setHardwareID("none");
  diagnostics_.add("frames to maps", this, &MappingNode::Diagnose);
  AdvertiseServices();
  StartTimers();
  service_spinner_.start();
}

void MappingNode::StartTimers() {
  edge_timer_ =
      node_.createWallTimer(ros::WallDuration(kEdgePeriodS), [this](const ros::WallTimerEvent&) {
        publisher_.PublishEdges(engine_.Picture(), Counters());
      });
  map_timer_ =
      node_.createWallTimer(ros::WallDuration(kMapPeriodS), [this](const ros::WallTimerEvent&) {
        publisher_.PublishMap(engine_.Picture(), Counters(), false);
        for (const std::string& sentence : news_.Since(engine_.Picture()))
          ROS_INFO_STREAM(sentence);
        finish_.Publish(engine_.Picture());
        // The time of now: answers that are queued already are taken before it is looked at.
        worker_.Push(kClockLane, [this, now_s = SteadySeconds()] {
          gap_filler_.CheckTime(now_s);
          engine_.ApplyDueResults();
          SaveNowAndThen(now_s);
          CountGaps();
        });
      });
}

void MappingNode::SaveNowAndThen(double now_s) {
  if (now_s < next_save_s_) return;
  next_save_s_ = now_s + kSavePeriodS;
  engine_.Save();
}

MappingNode::~MappingNode() { End(); }

bool MappingNode::End() {
  if (has_ended_) return options_.localize || maps_.IsWritten();
  has_ended_ = true;
  finish_.Stop();
  frame_subscriber_.Stop();
  match_subscriber_.shutdown();
  ROS_INFO_STREAM("ending: " << worker_.NumQueued(kFrameLane) << " events are still queued");
  WriteMaps();
  EndInTime([this] { DrainAndAdjust(); }, [this] { EndUnadjusted(); });
  publisher_.PublishMap(engine_.Picture(), Counters(), true);
  WriteMaps();
  if (options_.localize) return true;
  maps_.Tell(WhyNotMetric(engine_.Picture()));
  return maps_.IsWritten();
}

void MappingNode::EndUnadjusted() {
  ROS_WARN("no time was left for the final adjustment; the maps are as they were written last");
  maps_.Tell(WhyNotMetric(engine_.Picture()));
  std::_Exit(options_.localize || maps_.IsWritten() ? 0 : 1);
}

void MappingNode::DrainAndAdjust() {
  give_up_s_ = SteadySeconds() + options_.drain_s;
  fetcher_.Stop();
  service_spinner_.stop();
  worker_.Finish();
  gap_filler_.EndAllWaits(SteadySeconds());
  if (num_late_events_ > 0) ROS_WARN_STREAM(num_late_events_ << " queued events were not mapped");
  engine_.Save();
  WriteMaps();
  engine_.Finish();
}

void MappingNode::WriteMaps() {
  if (!options_.localize) maps_.Write(*engine_.Picture().snapshot);
}

void MappingNode::OnFrame(const FrameEventMsg::ConstPtr& message, FrameEvent event) {
  if (event.jpeg) {  // once in memory: in the message, which is kept for get_frames
    event.jpeg = {&message->jpeg, [message](const std::vector<uint8_t>*) {}};
  }
  auto add = [this, message, event = std::move(event)] {
    gap_filler_.Add(Arrived(message, event), SteadySeconds());
    CountGaps();
  };
  worker_.Push(kFrameLane, std::move(add), SizeOf(*message));
}

void MappingNode::OnPlaceMatch(const PlaceMatchMsg::ConstPtr& message) {
  std::string error;
  std::optional<PlaceMatch> match = FromMessage(*message, &error);
  if (!match) {
    refused_matches_.Note("place match refused: " + error, SteadySeconds());
    ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, refused_matches_.Reason());
    return;
  }
  const size_t num_bytes = SizeOf(*match);
  auto add = [this, match = std::move(*match)] { AddMatch(match); };
  if (!worker_.Push(kMatchLane, std::move(add), num_bytes)) {
    ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, "place match dropped: " << worker_.NumQueued(kMatchLane)
                                                                   << " wait to be judged");
  }
}

void MappingNode::AddMatch(const PlaceMatch& match) {
  if (IsTimeUp()) {
    ++num_late_matches_;
  } else if (!options_.localize) {
    engine_.Add(match);
  } else if (const auto pose = engine_.Localize(match)) {
    publisher_.PublishPose(engine_.Picture(), *pose);
  }
}

void MappingNode::OnAnswer(const GapFetch& fetch, std::vector<FetchedFrame> frames) {
  worker_.Push(kAnswerLane, [this, fetch, frames = std::move(frames)] {
    std::vector<ArrivedFrame> found;
    for (const FetchedFrame& frame : frames) found.push_back(Arrived(frame.message, frame.event));
    gap_filler_.TakeAnswer(fetch.ticket, found, SteadySeconds());
    CountGaps();
  });
}

ArrivedFrame MappingNode::Arrived(const FrameEventMsg::ConstPtr& message, const FrameEvent& event) {
  return {event.id, [this, message, event] { Map(message, event); }, SizeOf(*message)};
}

void MappingNode::CountGaps() {
  num_lost_gaps_ = gap_filler_.num_given_up();
  num_held_ = gap_filler_.NumHeld();
}

void MappingNode::Tick() {
  const bool has_frames = engine_.Picture().num_events > 0;
  hints_.Look(has_frames ? std::vector<AwaitedTopic>{} : AwaitedFrames(options_.robots),
              SteadySeconds());
  diagnostics_.update();
}

bool MappingNode::IsTimeUp() const { return give_up_s_ > 0.0 && SteadySeconds() > give_up_s_; }

IngestCounters MappingNode::Counters() const {
  IngestCounters counters;
  counters.refused = frame_subscriber_.refused().Count();
  counters.dropped = worker_.NumDropped(kFrameLane) + num_late_events_;
  counters.lost_gaps = num_lost_gaps_;
  counters.refused_matches = refused_matches_.Count();
  counters.dropped_matches = worker_.NumDropped(kMatchLane) + num_late_matches_;
  return counters;
}

void MappingNode::Map(const FrameEventMsg::ConstPtr& message, const FrameEvent& event) {
  if (IsTimeUp()) {
    ++num_late_events_;
    return;
  }
  if (options_.localize) {
    history_.Add(message);
    if (const auto pose = engine_.Localize(event)) publisher_.PublishPose(engine_.Picture(), *pose);
    return;
  }
  const MapperReport report = engine_.Add(event);
  if (report.outcome == MapperOutcome::kRefused) {
    unmapped_.Note("frame refused: " + report.reason, SteadySeconds());
    ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, "frame refused: " << report.reason);
    return;
  }
  history_.Add(message);
  publisher_.PublishPose(engine_.Picture(), report.session, event.id.index);
}

}  // namespace rovio_sfm
