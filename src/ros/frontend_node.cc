#include "rovio_sfm/ros/frontend_node.h"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/Image.h>

#include <stdexcept>
#include <utility>

#include "rovio_sfm/frontend/draw_matches.h"
#include "rovio_sfm/io/calibration.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr size_t kHistoryEvents = 100;
constexpr size_t kHistoryBytes = 100u << 20;
constexpr double kWarnPeriodS = 10.0;
constexpr uint32_t kAtStart = ~0u;  // dynamic_reconfigure's level of its first call

void PublishImage(const cv::Mat& bgr, const std_msgs::Header& header,
                  const ros::Publisher& publisher) {
  publisher.publish(cv_bridge::CvImage(header, "bgr8", bgr).toImageMsg());
}

Camera CameraIn(const std::string& calibration_file) {
  try {
    return ReadCamera(calibration_file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("calibration_file: ") + error.what());
  }
}

}  // namespace

FrontendNode::FrontendNode(const FrontendNodeOptions& options, uint32_t nonce, ros::NodeHandle node,
                           ros::NodeHandle private_node)
    : options_(options),
      frontend_options_(std::make_shared<const FrontendOptions>(options.frontend)),
      node_(node),
      transform_listener_(transforms_),
      sensors_(options.sensors, &transforms_),
      gate_(options.gate, &sensors_),
      history_(kHistoryEvents, kHistoryBytes),
      frontend_(options.frontend, options.robot, options.seed, nonce),
      subscribers_(options.topics, options.calibration_file.empty(), node, Callbacks()),
      diagnostics_(node, private_node),
      thresholds_(thresholds_mutex_, ros::NodeHandle(private_node, topics::kThresholds)),
      worker_(kImageQueue, WhenFull::kDropOldest, [this](const Job& job) { Handle(job); }) {
  diagnostics_.setHardwareID(options_.robot);
  diagnostics_.add("images to frames", this, &FrontendNode::Diagnose);
  thresholds_.setCallback(
      [this](FrontendThresholdsConfig& t, uint32_t level) { OnThresholds(t, level); });
  if (!options_.calibration_file.empty()) sensors_.SetCamera(CameraIn(options_.calibration_file));
  Advertise();
}

FrontendNode::~FrontendNode() { worker_.Finish(); }

void FrontendNode::Advertise() {
  frames_ = node_.advertise<FrameEventMsg>(topics::kFrames, topics::kFramesQueue);
  preview_ = node_.advertise<sensor_msgs::Image>(topics::kPreview, topics::kPreviewQueue);
  matches_ = node_.advertise<sensor_msgs::Image>(topics::kDebugMatches, topics::kPreviewQueue);
  get_frames_ = node_.advertiseService(topics::kGetFrames, &FrontendNode::GetFrames, this);
}

CameraCallbacks FrontendNode::Callbacks() {
  CameraCallbacks callbacks;
  callbacks.on_compressed = [this](const auto& message) { OnImage(message); };
  callbacks.on_image = [this](const auto& message) { OnImage(message); };
  callbacks.on_camera_info = [this](const auto& message) { OnCameraInfo(message); };
  callbacks.on_odometry = [this](const auto& message) { OnOdometry(message); };
  return callbacks;
}

template <typename Message>
void FrontendNode::OnImage(const boost::shared_ptr<const Message>& message) {
  has_image_ = true;
  const std_msgs::Header& header = message->header;
  std::string error = "header.stamp is zero: expected the time when it was taken";
  ImageBytes bytes = header.stamp.isZero() ? nullptr : BytesOf(*message, &error);
  if (bytes == nullptr) {
    return CountMalformed("image refused: " + error);
  }
  gate_.Add(
      {ToNanoseconds(header.stamp), header.frame_id, std::to_string(header.seq), std::move(bytes)},
      SteadySeconds());
  ReleaseImages();
}

void FrontendNode::OnCameraInfo(const sensor_msgs::CameraInfo::ConstPtr& message) {
  has_camera_info_ = true;
  std::string error;
  if (!sensors_.AddCameraInfo(*message, &error)) CountMalformed("camera_info refused: " + error);
}

void FrontendNode::OnOdometry(const nav_msgs::Odometry::ConstPtr& message) {
  std::string error;
  if (!sensors_.AddOdometry(*message, &error)) CountMalformed("odometry refused: " + error);
  ReleaseImages();
}

void FrontendNode::OnThresholds(FrontendThresholdsConfig& thresholds, uint32_t level) {
  FrontendOptions next = WithThresholds(*frontend_options_, thresholds);
  std::string error;
  if (level == kAtStart || !MayFollow(*frontend_options_, next, &error)) {
    if (!error.empty()) ROS_WARN_STREAM("thresholds refused, the old ones stay: " << error);
    thresholds = FrontendThresholdsConfig(*frontend_options_);
    return;
  }
  frontend_options_ = std::make_shared<const FrontendOptions>(std::move(next));
  ROS_INFO("new thresholds from the next image on");
}

void FrontendNode::CountMalformed(const std::string& reason) {
  malformed_.Note(reason, SteadySeconds());
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, reason);
}

// Of topics that are still guessed the search tells.
std::vector<AwaitedTopic> FrontendNode::Awaited() const {
  const CameraTopicOptions& topics = options_.topics;
  std::vector<AwaitedTopic> awaited;
  if (!has_image_ && topics.image != kGuessTopic) {
    const bool is_raw = topics.image_transport == "raw";
    awaited.push_back({"images",
                       node_.resolveName(topics.image + (is_raw ? "" : "/compressed")),
                       {"sensor_msgs/Image", "sensor_msgs/CompressedImage"}});
  }
  if (!has_camera_info_ && topics.camera_info != kGuessTopic) {
    awaited.push_back(
        {"camera_info", node_.resolveName(topics.camera_info), {"sensor_msgs/CameraInfo"}});
  }
  return awaited;
}

void FrontendNode::Tick() {
  subscribers_.Search();
  hints_.Look(Awaited(), SteadySeconds());
  ReleaseImages();
  pace_.Tick();
}

void FrontendNode::ReleaseImages() {
  while (std::optional<ImageEvent> image = gate_.Take(SteadySeconds())) {
    worker_.Push({std::move(*image), frontend_options_});
  }
}

bool FrontendNode::GetFrames(GetFramesRequest& request, GetFramesResponse& response) {
  response = history_.Page(request);
  return true;
}

void FrontendNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  Progress progress;
  {
    MutexLock lock(mutex_);
    progress = progress_;
  }
  using Level = diagnostic_msgs::DiagnosticStatus;
  const std::string malformed = malformed_.RecentReason(SteadySeconds());
  if (!malformed.empty()) {
    status.summary(Level::WARN, malformed);
  } else if (progress.counters.images == 0) {
    const char* reason = sensors_.HasCamera() ? "no images yet" : "no images or camera_info yet";
    status.summary(Level::WARN, reason);
  } else if (subscribers_.NumImagePublishers() == 0) {
    status.summary(Level::WARN, "nobody publishes images any more");
  } else if (!progress.last_refusal.empty()) {
    status.summary(Level::WARN, progress.last_refusal);
  } else {
    status.summary(Level::OK, "images become frames");
  }
  status.add("images", progress.counters.images);
  status.add("keyframes", progress.counters.keyframes);
  status.add("light frames", progress.counters.light_frames);
  status.add("frames with odometry", progress.num_with_odometry);
  status.add("images dropped, queue full", gate_.NumDropped() + worker_.NumDropped());
  status.add("images refused", progress.counters.refused);
  status.add("images repeated or late", progress.counters.late);
  status.add("images spoilt", progress.counters.spoilt);
  status.add("images without features", progress.counters.featureless);
  status.add("images lost by the tracker", progress.counters.untracked);
  status.add("malformed messages", malformed_.Count());
  status.add("newest malformed message", malformed_.Reason());
  status.add("drives", progress.counters.drives);
  status.add("last image took ms", 1e3 * progress.last_duration_s);
}

void FrontendNode::Handle(const Job& job) {
  const double start_s = SteadySeconds();
  std::string error;
  ROVIO_CHECK(frontend_.SetOptions(*job.options, &error), error);
  const PreparedImage prepared = PrepareImage(job.image, *job.options);
  const std::optional<FrameEvent> event = frontend_.Add(prepared);
  if (event) Publish(*event, prepared);
  NoteProgress(event, SteadySeconds() - start_s);
}

void FrontendNode::Publish(const FrameEvent& event, const PreparedImage& image) {
  const auto message = boost::make_shared<FrameEventMsg>(ToMessage(event));
  frames_.publish(message);
  history_.Add(message);
  if (preview_.getNumSubscribers() > 0) {
    PublishImage(DrawKeypoints(image.bgr, event), message->header, preview_);
  }
  if (event.kind != FrameKind::kKeyframe) return;
  if (matches_.getNumSubscribers() > 0 && drawn_) PublishMatches(event, image.bgr);
  drawn_ = Drawn{event, image.bgr};
}

void FrontendNode::PublishMatches(const FrameEvent& event, const cv::Mat& bgr) {
  if (event.pairs.empty() || event.pairs.front().other_index != drawn_->event.id.index) return;
  std_msgs::Header header;
  header.stamp = ToTime(event.stamp_ns);
  PublishImage(DrawMatches(drawn_->bgr, *drawn_->event.features, bgr, *event.features,
                           event.pairs.front(), frontend_.options().pair),
               header, matches_);
}

void FrontendNode::NoteProgress(const std::optional<FrameEvent>& event, double duration_s) {
  MutexLock lock(mutex_);
  progress_.counters = frontend_.counters();
  progress_.last_refusal = event ? "" : frontend_.last_refusal();
  progress_.last_duration_s = duration_s;
  if (event && event->odometry) ++progress_.num_with_odometry;
}

}  // namespace rovio_sfm
