#include "rovio_sfm/ros/bag_images.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {
namespace {

const char* const kTransforms = "/tf";
const char* const kStaticTransforms = "/tf_static";
constexpr double kForeverS = 1e6;
constexpr size_t kMaxReasons = 20;

std::string TopicOf(const BagDrive& drive, const char* name) {
  return "/" + drive.robot + "/" + name;
}

SensorOptions ForWholeBag(SensorOptions options, const std::string& robot) {
  options.odom_memory_s = kForeverS;
  if (options.base_frame.empty()) options.base_frame = robot + "/base_link";
  return options;
}

// The image topic of every robot; compressed ones win.
std::map<std::string, std::string> ImageTopics(const rosbag::Bag& bag) {
  const std::regex pattern("/([a-z][a-z0-9_]*)/image_raw(/compressed)?");
  std::map<std::string, std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    std::smatch match;
    if (!std::regex_match(connection->topic, match, pattern)) continue;
    std::string& topic = topics[match[1]];
    topic = std::max(topic, connection->topic);  // the compressed one is the longer
  }
  return topics;
}

void OpenBag(const std::filesystem::path& path, rosbag::Bag* bag) {
  try {
    bag->open(path.string(), rosbag::bagmode::Read);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace

std::vector<BagDrive> FindDrives(const std::vector<std::filesystem::path>& bags) {
  std::vector<BagDrive> drives;
  for (const std::filesystem::path& path : bags) {
    rosbag::Bag bag;
    OpenBag(path, &bag);
    const std::map<std::string, std::string> topics = ImageTopics(bag);
    if (topics.empty()) {
      throw std::runtime_error(path.string() +
                               ": no topic /<robot>/image_raw or /<robot>/image_raw/compressed");
    }
    for (const auto& [robot, topic] : topics) drives.push_back({path, robot, topic});
  }
  return drives;
}

BagImages::BagImages(const BagDrive& drive, SensorOptions options)
    : drive_(drive),
      transforms_(ros::Duration(kForeverS)),
      sensors_(ForWholeBag(std::move(options), drive.robot), &transforms_) {
  OpenBag(drive.bag, &bag_);
  ReadMotion(TopicOf(drive, topics::kOdom));
  ReadCameras(TopicOf(drive, topics::kCameraInfo));
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
  if (cameras_.empty()) throw std::runtime_error(drive_.bag.string() + ": " + error);
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
    if (odometry == nullptr) {
      CountRefusal(error);
      continue;
    }
    odometry->header.stamp = StampOf(message, odometry->header);
    if (!sensors_.AddOdometry(*odometry, &error)) CountRefusal("odometry: " + error);
  }
}

void BagImages::ReadTransforms(const rosbag::MessageInstance& message) {
  const auto list = message.instantiate<tf2_msgs::TFMessage>();
  if (list == nullptr) return;
  for (geometry_msgs::TransformStamped& transform : list->transforms) {
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
  return sensors_.MakeEvent({ToNanoseconds(header.stamp), header.frame_id, name, bytes});
}

}  // namespace rovio_sfm
