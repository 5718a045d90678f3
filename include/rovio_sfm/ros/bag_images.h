#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/ros/robot_sensors.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// The images of one robot in one bag.
struct BagDrive {
  std::filesystem::path bag;
  std::string robot;        // from the topic: /<robot>/image_raw...
  std::string image_topic;  // compressed, where a bag has both
  std::string info_topic;
  std::string odom_topic;
  std::optional<Camera> camera;  // from a file; none: as camera_info says
};

// Which topics of a bag are read where they are not named /<robot>/...; empty: those are.
struct BagTopics {
  std::string image, info, odom;
};

// All drives of the bags, in the order given, then by robot. Throws std::runtime_error naming the
// bag if it cannot be read or holds no /<robot>/image_raw or /<robot>/image_raw/compressed, nor the
// topics that were named; what it holds is listed. Of a named image topic, its first part names the
// robot, and where the others are expected.
std::vector<BagDrive> FindDrives(const std::vector<std::filesystem::path>& bags,
                                 const BagTopics& topics = {});

// The image events of a drive in the order of the bag, as a frontend node would make them: with
// odometry and the head's pose at each stamp. All else is read first, images one by one. Malformed
// messages are left out and counted.
class BagImages {
 public:
  // Throws std::runtime_error if the bag cannot be read or has no usable camera_info.
  BagImages(const BagDrive& drive, SensorOptions options);

  size_t Count() const { return num_images_; }
  size_t NumRefused() const { return num_refused_; }
  std::optional<ImageEvent> Next();
  // Why images came without the camera's place on the robot; empty where none did.
  std::string MissingHead() const;

 private:
  void ReadMotion(const std::string& odom_topic);
  void ReadCameras(const std::string& info_topic);
  const sensor_msgs::CameraInfo& CameraAt(const ros::Time& stamp) const;
  void ReadTransforms(const rosbag::MessageInstance& message);
  std::optional<ImageEvent> ReadImage(const rosbag::MessageInstance& message);

  BagDrive drive_;
  std::string base_frame_;
  rosbag::Bag bag_;
  tf2::BufferCore transforms_;
  RobotSensors sensors_;
  std::map<ros::Time, sensor_msgs::CameraInfo> cameras_;
  std::unique_ptr<rosbag::View> view_;  // images
  rosbag::View::iterator next_;
  std::string headless_frame_;  // of the newest image without the camera's place
  bool lacks_head_ = false;
  size_t num_images_ = 0;
  size_t num_read_ = 0;
  size_t num_refused_ = 0;
};

}  // namespace rovio_sfm
