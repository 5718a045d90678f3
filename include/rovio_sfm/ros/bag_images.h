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

#include "rovio_sfm/ros/bag_topics.h"
#include "rovio_sfm/ros/robot_sensors.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// The image events of a drive in the order of the bag, as a frontend node would make them: with
// odometry and the head's pose at each stamp. All else is read first, images one by one. Malformed
// messages, and images whose stamp is zero, are left out and counted by reason; edges of tf that
// belong to an earlier map are left out.
class BagImages {
 public:
  // Throws std::runtime_error if the bag cannot be read or, without a camera, has no usable
  // camera_info.
  BagImages(const BagDrive& drive, const SensorOptions& options,
            const std::optional<Camera>& camera = std::nullopt);

  size_t Count() const { return num_images_; }
  size_t NumRefused() const { return num_refused_; }
  size_t NumMapEdges() const { return num_map_edges_; }
  const std::map<std::string, size_t>& Refusals() const { return refusals_; }
  std::optional<ImageEvent> Next();
  // Of the images so far: nothing where some came with odometry and the head's pose, else one
  // sentence that says what a metric map lacks.
  std::optional<std::string> WhyNotMetric() const;

 private:
  void CountMotion(const ImageEvent& event);
  std::string FramesText() const;
  void ReadMotion(const std::string& odom_topic);
  void ReadCameras(const std::string& info_topic);
  const sensor_msgs::CameraInfo& CameraAt(const ros::Time& stamp) const;
  void ReadTransforms(const rosbag::MessageInstance& message);
  std::optional<ImageEvent> ReadImage(const rosbag::MessageInstance& message);
  ros::Time StampOf(const rosbag::MessageInstance& message, const std_msgs::Header& header) const;
  void CountRefusal(const std::string& reason);

  BagDrive drive_;
  rosbag::Bag bag_;
  tf2::BufferCore transforms_;
  RobotSensors sensors_;
  std::map<ros::Time, sensor_msgs::CameraInfo> cameras_;
  std::unique_ptr<rosbag::View> view_;  // images
  rosbag::View::iterator next_;
  size_t num_images_ = 0;
  size_t num_read_ = 0;
  size_t num_refused_ = 0;
  std::map<std::string, size_t> refusals_;  // by reason; the first kMaxReasons of them
  size_t num_map_edges_ = 0;
  std::string base_frame_;
  std::string camera_frame_;                   // of the newest image
  size_t num_odometry_ = 0;                    // taken
  std::string odometry_refusal_;               // the first
  size_t num_with_head_ = 0, num_metric_ = 0;  // images
};

}  // namespace rovio_sfm
