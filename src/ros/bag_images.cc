#include "rovio_sfm/ros/bag_images.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {
namespace {

const char* const kTransforms = "/tf";
const char* const kStaticTransforms = "/tf_static";
constexpr double kForeverS = 1e6;
constexpr size_t kMaxReasons = 20;

SensorOptions ForWholeBag(SensorOptions options, const std::string& robot) {
  options.odom_memory_s = kForeverS;
  if (options.base_frame.empty()) options.base_frame = robot + "/base_link";
  return options;
}

}  // namespace

BagImages::BagImages(const BagDrive& drive, const SensorOptions& options,
                     const std::optional<Camera>& camera)
    : drive_(drive),
      transforms_(ros::Duration(kForeverS)),
      sensors_(ForWholeBag(options, drive.robot), &transforms_),
      base_frame_(ForWholeBag(options, drive.robot).base_frame) {
  OpenBag(drive.bag, &bag_);
  WithBagNamed(drive.bag, [&] {
    ReadMotion(drive.odom_topic);
    if (camera) {
      cameras_.emplace(ros::Time(), ToCameraInfo(*camera, 0, ""));
    } else {
      ReadCameras(drive.info_topic);
    }
  });
  view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(drive.image_topic));
  num_images_ = view_->size();
  next_ = view_->begin();
}

void BagImages::ReadCameras(const std::string& info_topic) {
  rosbag::View view(bag_, rosbag::TopicQuery(info_topic));
  std::string error = "no " + info_topic;
  for (const rosbag::MessageInstance& message : view) {
    const auto info = message.instantiate<sensor_msgs::CameraInfo>();
    if (info != nullptr && FromCameraInfo(*info, &error)) {
      cameras_.emplace(StampOf(message, info->header), *info);
    } else {
      CountRefusal(error);
    }
  }
  if (!cameras_.empty()) return;
  throw std::runtime_error(drive_.bag.string() + ": " + error +
                           "; --calibration gives a file instead, --camera-info-topic one of: " +
                           TopicsOfType(bag_, {"sensor_msgs/CameraInfo"}));
}

void BagImages::ReadMotion(const std::string& odom_topic) {
  const std::vector<std::string> topics = {odom_topic, kTransforms, kStaticTransforms};
  rosbag::View view(bag_, rosbag::TopicQuery(topics));
  for (const rosbag::MessageInstance& message : view) {
    if (message.getTopic() != odom_topic) {
      ReadTransforms(message);
      continue;
    }
    const auto odometry = message.instantiate<nav_msgs::Odometry>();
    std::string error = odom_topic + " is no nav_msgs/Odometry";
    if (odometry != nullptr) {
      odometry->header.stamp = StampOf(message, odometry->header);
      if (sensors_.AddOdometry(*odometry, &error)) {
        ++num_odometry_;
        continue;
      }
    }
    CountRefusal("odometry: " + error);
    if (odometry_refusal_.empty()) odometry_refusal_ = error;
  }
}

void BagImages::ReadTransforms(const rosbag::MessageInstance& message) {
  const auto list = message.instantiate<tf2_msgs::TFMessage>();
  if (list == nullptr) return;
  for (geometry_msgs::TransformStamped& transform : list->transforms) {
    if (IsMapEdge(transform)) {
      ++num_map_edges_;
      continue;
    }
    transform.header.stamp = StampOf(message, transform.header);
    transforms_.setTransform(transform, "bag", message.getTopic() == kStaticTransforms);
  }
}

std::optional<ImageEvent> BagImages::Next() {
  while (next_ != view_->end()) {
    const rosbag::MessageInstance message = *next_;
    ++next_;
    if (std::optional<ImageEvent> event = ReadImage(message)) return event;
  }
  return std::nullopt;
}

void BagImages::CountRefusal(const std::string& reason) {
  ++num_refused_;
  if (refusals_.size() < kMaxReasons || refusals_.count(reason) > 0) ++refusals_[reason];
}

ros::Time BagImages::StampOf(const rosbag::MessageInstance& message,
                             const std_msgs::Header& header) const {
  return drive_.stamps == StampSource::kBag ? message.getTime() : header.stamp;
}

// The last one up to the stamp; the first of all for images before it.
const sensor_msgs::CameraInfo& BagImages::CameraAt(const ros::Time& stamp) const {
  const auto later = cameras_.upper_bound(stamp);
  return later == cameras_.begin() ? later->second : std::prev(later)->second;
}

std::optional<ImageEvent> BagImages::ReadImage(const rosbag::MessageInstance& message) {
  const std::string number = std::to_string(num_read_++);
  const std::string name = std::string(6 - std::min<size_t>(6, number.size()), '0') + number;
  std::string error = "no image message";
  std_msgs::Header header;
  ImageBytes bytes;
  if (const auto compressed = message.instantiate<sensor_msgs::CompressedImage>()) {
    header = compressed->header;
    bytes = BytesOf(*compressed, &error);
  } else if (const auto raw = message.instantiate<sensor_msgs::Image>()) {
    header = raw->header;
    bytes = BytesOf(*raw, &error);
  }
  header.stamp = StampOf(message, header);
  if (bytes != nullptr && header.stamp.isZero()) {
    error = "image: header.stamp is zero (--stamps bag takes the bag's time)";
    bytes = nullptr;
  }
  if (bytes == nullptr || !sensors_.AddCameraInfo(CameraAt(header.stamp), &error)) {
    CountRefusal(error);
    return std::nullopt;
  }
  ImageEvent event =
      sensors_.MakeEvent({ToNanoseconds(header.stamp), header.frame_id, name, bytes});
  CountMotion(event);
  return event;
}

void BagImages::CountMotion(const ImageEvent& event) {
  camera_frame_ = event.camera_frame;
  if (event.base_from_camera) ++num_with_head_;
  if (event.odometry && event.base_from_camera) ++num_metric_;
}

std::string BagImages::FramesText() const {
  std::vector<std::string> frames;
  transforms_._getFrameStrings(frames);
  std::sort(frames.begin(), frames.end());
  std::string text;
  for (const std::string& frame : frames) text += (text.empty() ? "" : ", ") + frame;
  return text.empty() ? "none" : text;
}

std::optional<std::string> BagImages::WhyNotMetric() const {
  if (num_metric_ > 0) return std::nullopt;
  if (num_odometry_ == 0) {
    if (!odometry_refusal_.empty()) return "all odometry was refused: " + odometry_refusal_;
    return "no odometry on " + drive_.odom_topic +
           " (--odom-topic; nav_msgs/Odometry is on: " + TopicsOfType(bag_, {"nav_msgs/Odometry"}) +
           ")";
  }
  if (num_with_head_ == 0) {
    return "no tf between " + base_frame_ + " and the images' frame '" + camera_frame_ +
           "' (--base-frame; frames in the bag: " + FramesText() + ")";
  }
  return "odometry and tf never cover the same image's stamp";
}

}  // namespace rovio_sfm
