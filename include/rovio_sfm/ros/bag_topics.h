#pragma once

#include <rosbag/bag.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace rovio_sfm {

// Which time a message counts as of: its header's, or when it was recorded.
enum class StampSource { kHeader, kBag };

// Where the images of a bag and what belongs to them are to be found; an empty name means: under
// the names that this package uses.
struct BagTopics {
  std::string image;        // with or without /compressed
  std::string camera_info;  // else beside the images
  std::string odom;         // else below the robot's name
  StampSource stamps = StampSource::kHeader;
};

// The images of one robot in one bag.
struct BagDrive {
  std::filesystem::path bag;
  std::string robot;        // the first part of the image topic, as robots are named
  std::string image_topic;  // compressed, where a bag has both
  std::string info_topic;
  std::string odom_topic;
  StampSource stamps = StampSource::kHeader;
};

// What rosbag throws while a bag is read, as a std::runtime_error that names it.
template <typename Read>
auto WithBagNamed(const std::filesystem::path& path, const Read& read) {
  try {
    return read();
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path.string() + ": no bag, or not a whole one: " + error.what());
  }
}

// Opens a bag for reading. Throws std::runtime_error that names the bag, and what mends one that
// was not closed.
void OpenBag(const std::filesystem::path& path, rosbag::Bag* bag);

// The topics of a type ("sensor_msgs/CameraInfo") in the bag, separated by commas; "none" without.
std::string TopicsOfType(const rosbag::Bag& bag, const std::vector<std::string>& types);

// All drives of the bags, in the order given, then by robot: of the topics /<robot>/image_raw and
// /<robot>/image_raw/compressed, or of the image topic that was asked for. Throws
// std::runtime_error naming the bag if it cannot be read or holds none; the message lists the
// images that it holds.
std::vector<BagDrive> FindDrives(const std::vector<std::filesystem::path>& bags,
                                 const BagTopics& topics = {});

}  // namespace rovio_sfm
