#include "rovio_sfm/ros/driver_images.h"

#include <ros/console.h>
#include <ros/time.h>

#include <array>
#include <utility>

#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

// Of the resolutions 0 … 3, as the firmware has them.
constexpr std::array<std::pair<int, int>, 4> kSizes = {
    {{176, 144}, {320, 240}, {352, 288}, {640, 480}}};
constexpr int64_t kSizeChangeNs = 5000000000;
constexpr int64_t kSettingsPatienceNs = 10'000'000'000;

int64_t RosNs() { return static_cast<int64_t>(ros::Time::now().toNSec()); }

// A robot that looks once per stop has no use for a stream.
ImageReaderOptions ReaderOptions(const DriverOptions& options) {
  ImageReaderOptions reader = options.images;
  if (options.capture_mode == CaptureMode::kStationary && reader.source == ImageSource::kAuto) {
    reader.source = ImageSource::kStills;
  }
  return reader;
}

}  // namespace

DriverImages::DriverImages(const ros::NodeHandle& handle, const DriverOptions& options,
                           const Credentials& credentials)
    : is_stationary_(options.capture_mode == CaptureMode::kStationary),
      keeps_settings_(options.reports.wanted_settings.has_value()),
      start_ns_(SteadyNs()),
      resolution_(static_cast<size_t>(
          options.reports.wanted_settings.value_or(CameraSettings{}).resolution)),
      may_read_(!keeps_settings_),
      has_settings_(!keeps_settings_),
      trigger_(options.stationary),
      transport_(options.http, credentials),
      gate_(!is_stationary_ && !keeps_settings_),
      publisher_(handle, options),
      publish_worker_(1, WhenFull::kDropOldest,
                      [this](const CameraImage& image) { publisher_.Publish(image); }),
      reader_(ReaderOptions(options), &transport_, &gate_, MakeCallbacks()),
      reader_thread_([this] { reader_.Run(); }) {}

DriverImages::~DriverImages() {
  gate_.Stop();
  transport_.Cancel();
  reader_thread_.join();
  publish_worker_.Stop();
}

ImageReader::Callbacks DriverImages::MakeCallbacks() {
  ImageReader::Callbacks callbacks;
  callbacks.on_image = [this](CameraImage image) { OnImage(std::move(image)); };
  callbacks.on_link = [this](ImageLink link, const std::string& reason) { OnLink(link, reason); };
  callbacks.now_ns = RosNs;
  callbacks.steady_ns = SteadyNs;
  return callbacks;
}

void DriverImages::NoteMotion(bool is_moving, int64_t now_ns) {
  if (!is_stationary_) return;
  MutexLock lock(mutex_);
  trigger_.Note(is_moving, now_ns);
  // The one image of a stop waits for somebody to see it.
  gate_.SetOpen(may_read_ && trigger_.WantsImage(now_ns) && publisher_.HasListeners());
}

void DriverImages::BeginReading() {
  may_read_ = true;
  if (!is_stationary_) gate_.SetOpen(true);
}

// An image tells that it came too.
void DriverImages::NoteLink(bool is_up, int64_t now_ns) {
  MutexLock lock(mutex_);
  if (is_up) {
    heard_ns_ = now_ns;
  } else if (settings_ns_) {
    heard_ns_.reset();
    has_settings_ = false;
  }
}

void DriverImages::NoteSettings(const SomeSettings& settings) {
  MutexLock lock(mutex_);
  const auto told = static_cast<size_t>(settings.resolution.value_or(0));
  if (settings.resolution && told < kSizes.size()) resolution_ = told;
  has_settings_ = true;
  settings_ns_ = SteadyNs();
  BeginReading();
}

void DriverImages::CheckSettings(int64_t now_ns) {
  MutexLock lock(mutex_);
  if (!may_read_ && now_ns - start_ns_ >= kSettingsPatienceNs) BeginReading();
  if (has_settings_ || !heard_ns_ || now_ns - *heard_ns_ < kSettingsPatienceNs) return;
  has_settings_ = true;
  ROS_WARN_NAMED("images",
                 "the robot has not told its camera settings for %d s: its images are "
                 "taken as they are",
                 static_cast<int>(kSettingsPatienceNs / 1'000'000'000));
}

// The robot reports a new size before it sends it.
bool DriverImages::IsOfOldSize(const CameraImage& image) const {
  const bool changes = settings_ns_ && image.complete_ns - *settings_ns_ <= kSizeChangeNs;
  if (has_settings_ && !changes) return false;
  const auto& [width_px, height_px] = kSizes[resolution_];
  return image.width_px != width_px || image.height_px != height_px;
}

void DriverImages::OnImage(CameraImage image) {
  {
    MutexLock lock(mutex_);
    heard_ns_ = heard_ns_.value_or(image.complete_ns);
    if (IsOfOldSize(image)) {
      ++num_of_old_size_;
      return;
    }
    statistics_.Add(image.first_byte_ns, image.complete_ns);
    if (is_stationary_) {
      if (!publisher_.HasListeners() || !trigger_.Accept(image.first_byte_ns)) return;
      gate_.SetOpen(false);
    }
  }
  publish_worker_.Push(std::move(image));
}

void DriverImages::OnLink(ImageLink link, const std::string& reason) {
  if (link == ImageLink::kDown) {
    ROS_WARN_STREAM_NAMED("images", "no images: " << reason);
  } else {
    ROS_INFO_STREAM_NAMED("images", "images by " << NameOf(link));
  }
  MutexLock lock(mutex_);
  link_ = link;
  reason_ = reason;
}

ImageLink DriverImages::Link() const {
  MutexLock lock(mutex_);
  return link_;
}

uint64_t DriverImages::NumDropped() const {
  const ImageCounters& counters = reader_.Counters();
  return counters.num_truncated + counters.num_corrupt + counters.num_too_large +
         publish_worker_.NumDropped() + publisher_.NumWithoutTime() + num_of_old_size_;
}

ImagesState DriverImages::TakeState() {
  ImagesState state;
  state.num_published = NumPublished();
  state.num_dropped = publish_worker_.NumDropped();
  state.num_without_time = publisher_.NumWithoutTime();
  state.is_calibrated = publisher_.IsCalibrated();
  MutexLock lock(mutex_);
  state.link = link_;
  state.reason = reason_;
  state.figures = statistics_.Take();
  return state;
}

}  // namespace rovio_sfm
