#include "rovio_sfm/ros/bag_topics.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>

#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
namespace {

const char kCompressed[] = "/compressed";
const std::vector<std::string> kImageTypes = {"sensor_msgs/Image", "sensor_msgs/CompressedImage"};

std::set<std::string> TopicsIn(const rosbag::Bag& bag) {
  std::set<std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    topics.insert(connection->topic);
  }
  return topics;
}

std::string WithoutCompressed(const std::string& topic) {
  if (!EndsWith(topic, kCompressed)) return topic;
  return topic.substr(0, topic.size() - (sizeof(kCompressed) - 1));
}

std::string FirstPart(const std::string& topic) {
  const size_t begin = topic.find_first_not_of('/');
  if (begin == std::string::npos) return "";
  return topic.substr(begin, topic.find('/', begin) - begin);
}

// A name that robots may bear: /Robot-1/... is the drive of robot_1.
std::string RobotOf(const std::string& topic) {
  std::string robot = FirstPart(topic).substr(0, 32);
  for (char& letter : robot) {
    const auto byte = static_cast<unsigned char>(letter);
    letter = std::isalnum(byte) ? static_cast<char>(std::tolower(byte)) : '_';
  }
  const bool begins_well = !robot.empty() && std::isalpha(static_cast<unsigned char>(robot[0]));
  return begins_well ? robot : "robot";
}

BagDrive DriveOf(const std::filesystem::path& bag, const std::string& image_topic,
                 const BagTopics& topics) {
  const std::string base = WithoutCompressed(image_topic);
  BagDrive drive{bag,         RobotOf(image_topic), image_topic, topics.camera_info,
                 topics.odom, topics.stamps};
  if (drive.info_topic.empty()) {
    drive.info_topic = base.substr(0, base.rfind('/')) + "/" + topics::kCameraInfo;
  }
  if (drive.odom_topic.empty()) drive.odom_topic = "/" + FirstPart(base) + "/" + topics::kOdom;
  return drive;
}

// The image topic of every robot; compressed ones win.
std::map<std::string, std::string> OwnImageTopics(const std::set<std::string>& topics) {
  const std::regex pattern("/([a-z][a-z0-9_]*)/image_raw(/compressed)?");
  std::map<std::string, std::string> found;
  for (const std::string& topic : topics) {
    std::smatch match;
    if (!std::regex_match(topic, match, pattern)) continue;
    std::string& best = found[match[1]];
    best = std::max(best, topic);  // the compressed one is the longer
  }
  return found;
}

std::optional<std::string> FindTopic(const std::set<std::string>& topics, std::string name) {
  if (!name.empty() && name.front() != '/') name.insert(0, "/");
  for (const std::string& candidate : {WithoutCompressed(name) + kCompressed, name}) {
    if (topics.count(candidate) > 0) return candidate;
  }
  return std::nullopt;
}

[[noreturn]] void RefuseBag(const std::filesystem::path& path, const rosbag::Bag& bag,
                            const std::string& missing) {
  throw std::runtime_error(path.string() + ": no topic " + missing +
                           "; topics of images (--image-topic): " + TopicsOfType(bag, kImageTypes));
}

void AddDrivesOf(const std::filesystem::path& path, const BagTopics& wanted,
                 std::vector<BagDrive>* drives) {
  rosbag::Bag bag;
  OpenBag(path, &bag);
  const std::set<std::string> topics = TopicsIn(bag);
  if (!wanted.image.empty()) {
    const std::optional<std::string> topic = FindTopic(topics, wanted.image);
    if (!topic) RefuseBag(path, bag, wanted.image);
    drives->push_back(DriveOf(path, *topic, wanted));
    return;
  }
  const std::map<std::string, std::string> own = OwnImageTopics(topics);
  if (own.empty()) RefuseBag(path, bag, "/<robot>/image_raw or /<robot>/image_raw/compressed");
  for (const auto& [robot, topic] : own) drives->push_back(DriveOf(path, topic, wanted));
}

}  // namespace

void OpenBag(const std::filesystem::path& path, rosbag::Bag* bag) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(path.string() + ": is a folder; expected a bag");
  }
  if (!std::filesystem::exists(path)) throw std::runtime_error(path.string() + ": no such file");
  WithBagNamed(path, [&] {
    try {
      bag->open(path.string(), rosbag::bagmode::Read);
    } catch (const rosbag::BagUnindexedException&) {
      throw std::runtime_error(path.string() + ": was not closed when it was recorded; " +
                               "`rosbag reindex " + path.string() + "` mends it");
    }
  });
}

std::string TopicsOfType(const rosbag::Bag& bag, const std::vector<std::string>& types) {
  std::set<std::string> found;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    if (std::find(types.begin(), types.end(), connection->datatype) != types.end()) {
      found.insert(connection->topic);
    }
  }
  std::string text;
  for (const std::string& topic : found) text += (text.empty() ? "" : ", ") + topic;
  return text.empty() ? "none" : text;
}

std::vector<BagDrive> FindDrives(const std::vector<std::filesystem::path>& bags,
                                 const BagTopics& topics) {
  std::vector<BagDrive> drives;
  for (const std::filesystem::path& path : bags) {
    WithBagNamed(path, [&] { AddDrivesOf(path, topics, &drives); });
  }
  return drives;
}

}  // namespace rovio_sfm
