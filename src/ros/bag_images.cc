#include "rovio_sfm/ros/bag_images.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {
namespace {

const char* const kTransforms = "/tf";
const char* const kStaticTransforms = "/tf_static";
constexpr double kForeverS = 1e6;

SensorOptions ForWholeBag(SensorOptions options, const std::string& robot) {
  options.odom_memory_s = kForeverS;
  if (options.base_frame.empty()) options.base_frame = robot + "/base_link";
  return options;
}

// Of all topics of these types, one after the other.
std::string ListTopics(const rosbag::Bag& bag, const std::set<std::string>& types) {
  std::set<std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (types.count(connection->datatype) > 0) topics.insert(connection->topic);
  }
  std::string list;
  for (const std::string& topic : topics) list += (list.empty() ? "" : ", ") + topic;
  return list.empty() ? "none" : list;
}

std::string ListImageTopics(const rosbag::Bag& bag) {
  return ListTopics(bag, {"sensor_msgs/Image", "sensor_msgs/CompressedImage"});
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

// A robot's name from the first part of a topic.
std::string RobotOf(const std::string& topic) {
  const size_t begin = topic.find_first_not_of('/');
  std::string name;
  for (const char c : topic.substr(begin, topic.find('/', begin) - begin)) {
    const auto letter = static_cast<unsigned char>(c);
    name += std::isalnum(letter) != 0 ? static_cast<char>(std::tolower(letter)) : '_';
  }
  return std::isalpha(static_cast<unsigned char>(name.front())) != 0 ? name : "robot_" + name;
}

// Beside an image topic, as image_transport expects it.
std::string InfoTopicOf(std::string image_topic) {
  const std::string compressed = "/compressed";
  const size_t end = image_topic.size() - std::min(image_topic.size(), compressed.size());
  if (image_topic.compare(end, std::string::npos, compressed) == 0) image_topic.resize(end);
  return image_topic.substr(0, image_topic.rfind('/') + 1) + topics::kCameraInfo;
}

BagDrive DriveOf(const std::filesystem::path& path, const std::string& robot,
                 const std::string& image_topic, const BagTopics& topics) {
  const std::string space = image_topic.substr(0, image_topic.find('/', 1) + 1);
  return {path,
          robot,
          image_topic,
          topics.info.empty() ? InfoTopicOf(image_topic) : topics.info,
          topics.odom.empty() ? space + rovio_sfm::topics::kOdom : topics.odom,
          std::nullopt};
}

void RequireTopic(const std::filesystem::path& path, const rosbag::Bag& bag,
                  const std::string& topic) {
  if (topic.empty()) return;
  if (rosbag::View(bag, rosbag::TopicQuery(topic)).size() > 0) return;
  throw std::runtime_error(path.string() + ": no topic " + topic +
                           "; its image topics: " + ListImageTopics(bag));
}

void OpenBag(const std::filesystem::path& path, rosbag::Bag* bag) {
  try {
    bag->open(path.string(), rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(path.string() + ": was not closed by its recorder; mend it first: " +
                             "rosbag reindex " + path.string());
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path.string() + ": " + error.what());
  }
}

}  // namespace

std::vector<BagDrive> FindDrives(const std::vector<std::filesystem::path>& bags,
                                 const BagTopics& topics) {
  std::vector<BagDrive> drives;
  for (const std::filesystem::path& path : bags) {
    rosbag::Bag bag;
    OpenBag(path, &bag);
    for (const std::string& topic : {topics.image, topics.info, topics.odom}) {
      RequireTopic(path, bag, topic);
    }
    if (!topics.image.empty()) {
      drives.push_back(DriveOf(path, RobotOf(topics.image), topics.image, topics));
      continue;
    }
    const std::map<std::string, std::string> found = ImageTopics(bag);
    if (found.empty()) {
      throw std::runtime_error(path.string() + ": no topic /<robot>/image_raw or " +
                               "/<robot>/image_raw/compressed; its image topics: " +
                               ListImageTopics(bag) + " (--image-topic takes one)");
    }
    for (const auto& [robot, topic] : found) drives.push_back(DriveOf(path, robot, topic, topics));
  }
  return drives;
}

BagImages::BagImages(const BagDrive& drive, SensorOptions options)
    : drive_(drive),
      base_frame_(ForWholeBag(options, drive.robot).base_frame),
      transforms_(ros::Duration(kForeverS)),
      sensors_(ForWholeBag(std::move(options), drive.robot), &transforms_) {
  OpenBag(drive.bag, &bag_);
  ReadMotion(drive.odom_topic);
  if (drive.camera) sensors_.SetCamera(*drive.camera);
  if (!drive.camera) ReadCameras(drive.info_topic);
  view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(drive.image_topic));
  num_images_ = view_->size();
  next_ = view_->begin();
}

std::string BagImages::MissingHead() const {
  if (!lacks_head_) return "";
  std::vector<std::string> frames;
  transforms_._getFrameStrings(frames);
  std::sort(frames.begin(), frames.end());
  std::string list;
  for (const std::string& frame : frames) list += (list.empty() ? "" : ", ") + frame;
  return "no tf between " + base_frame_ + " and " +
         (headless_frame_.empty() ? "the camera (its images name no frame)" : headless_frame_) +
         "; the bag's frames: " + (list.empty() ? "none" : list) +
         " (--base-frame names the robot's)";
}

void BagImages::ReadCameras(const std::string& info_topic) {
  rosbag::View view(bag_, rosbag::TopicQuery(info_topic));
  std::string error = "no " + info_topic;
  for (const rosbag::MessageInstance& message : view) {
    const auto info = message.instantiate<sensor_msgs::CameraInfo>();
    if (info != nullptr && FromCameraInfo(*info, &error)) {
      cameras_.emplace(info->header.stamp, *info);
    } else {
      ++num_refused_;
    }
  }
  if (!cameras_.empty()) return;
  throw std::runtime_error(drive_.bag.string() + ": " + error + "; its topics of that type: " +
                           ListTopics(bag_, {"sensor_msgs/CameraInfo"}) +
                           " (--camera-info-topic takes one, --calibration a file)");
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
    std::string error;
    if (odometry == nullptr || !sensors_.AddOdometry(*odometry, &error)) ++num_refused_;
  }
}

void BagImages::ReadTransforms(const rosbag::MessageInstance& message) {
  const auto list = message.instantiate<tf2_msgs::TFMessage>();
  if (list == nullptr) return;
  for (const geometry_msgs::TransformStamped& transform : list->transforms) {
    transforms_.setTransform(transform, "bag", message.getTopic() == kStaticTransforms);
  }
}

std::optional<ImageEvent> BagImages::Next() {
  while (next_ != view_->end()) {
    const rosbag::MessageInstance message = *next_;
    ++next_;
    if (std::optional<ImageEvent> event = ReadImage(message)) {
      lacks_head_ = lacks_head_ || !event->base_from_camera;
      if (!event->base_from_camera) headless_frame_ = event->camera_frame;
      return event;
    }
    ++num_refused_;
  }
  return std::nullopt;
}

// The last one up to the stamp; the first of all for images before it.
const sensor_msgs::CameraInfo& BagImages::CameraAt(const ros::Time& stamp) const {
  const auto later = cameras_.upper_bound(stamp);
  return later == cameras_.begin() ? later->second : std::prev(later)->second;
}

std::optional<ImageEvent> BagImages::ReadImage(const rosbag::MessageInstance& message) {
  const std::string number = std::to_string(num_read_++);
  const std::string name = std::string(6 - std::min<size_t>(6, number.size()), '0') + number;
  std::string error;
  std_msgs::Header header;
  ImageBytes bytes;
  if (const auto compressed = message.instantiate<sensor_msgs::CompressedImage>()) {
    header = compressed->header;
    bytes = BytesOf(*compressed, &error);
  } else if (const auto raw = message.instantiate<sensor_msgs::Image>()) {
    header = raw->header;
    bytes = BytesOf(*raw, &error);
  }
  const bool has_camera = drive_.camera || sensors_.AddCameraInfo(CameraAt(header.stamp), &error);
  if (bytes == nullptr || !has_camera) return std::nullopt;
  return sensors_.MakeEvent({ToNanoseconds(header.stamp), header.frame_id, name, bytes});
}

}  // namespace rovio_sfm
