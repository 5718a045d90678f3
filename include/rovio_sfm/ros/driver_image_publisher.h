#pragma once

#include <camera_info_manager/camera_info_manager.h>
#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/SetCameraInfo.h>

#include <atomic>
#include <optional>
#include <string>

#include "rovio_sfm/app/driver_options.h"

namespace rovio_sfm {

// Publishes images as the robot sent them, with camera_info, and decoded while somebody listens.
// Offers set_camera_info, which keeps what can be used. Publish belongs to one thread.
class DriverImagePublisher {
 public:
  DriverImagePublisher(const ros::NodeHandle& handle, const DriverOptions& options);

  // An image from before there was a time (/use_sim_time without /clock) is counted and dropped.
  void Publish(const CameraImage& image);

  // Whether somebody wants images; any thread.
  bool HasListeners() const;

  uint64_t NumPublished() const { return num_published_; }
  uint64_t NumWithoutTime() const { return num_without_time_; }
  // Whether the newest image was published with a calibration of its size.
  bool IsCalibrated() const { return is_calibrated_; }

 private:
  void LoadCalibration(const std::string& url, const std::string& camera_name);
  bool HasUsableCalibration();
  bool SetCameraInfo(sensor_msgs::SetCameraInfo::Request& request,
                     sensor_msgs::SetCameraInfo::Response& response);
  std::string CalibrationFile();
  void DropWithoutTime();
  sensor_msgs::CameraInfo InfoFor(const CameraImage& image);
  void PublishDecoded(const CameraImage& image, const std_msgs::Header& header);

  ros::NodeHandle handle_;
  const std::string frame_id_;
  const int64_t latency_ns_;
  image_transport::ImageTransport transport_;
  const std::string camera_name_, camera_info_url_;
  camera_info_manager::CameraInfoManager info_manager_;
  ros::ServiceServer set_camera_info_;
  ros::Publisher compressed_;
  ros::Publisher info_;
  image_transport::Publisher decoded_;
  bool has_warned_of_size_ = false, has_warned_of_time_ = false;
  std::atomic<bool> is_calibrated_{true};
  std::atomic<uint64_t> num_without_time_{0};
  std::atomic<uint64_t> num_published_{0};
};

}  // namespace rovio_sfm
