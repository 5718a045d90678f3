#pragma once

#include <image_transport/image_transport.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/app/camera_topics.h"

namespace rovio_sfm {

// What a frontend does with what its camera's topics bring.
struct CameraCallbacks {
  std::function<void(const sensor_msgs::CompressedImageConstPtr&)> on_compressed;
  std::function<void(const sensor_msgs::ImageConstPtr&)> on_image;
  std::function<void(const sensor_msgs::CameraInfoConstPtr&)> on_camera_info;
  std::function<void(const nav_msgs::OdometryConstPtr&)> on_odometry;
};

// Subscribes a camera's topics; those to be guessed as soon as they are there. Compressed images
// come as the bytes that were sent; every other transport is image_transport's. Used by one thread.
class CameraSubscribers {
 public:
  // Without a topic of camera_info where the camera is known already.
  CameraSubscribers(const CameraTopicOptions& options, bool needs_camera_info, ros::NodeHandle node,
                    CameraCallbacks callbacks);

  // Looks for what is to be guessed; call often. Throws std::runtime_error that lists them where
  // there are several of a kind.
  void Search();
  // How many nodes publish the images.
  uint32_t NumImagePublishers() const;

 private:
  void SubscribeImages(const ImageTopic& topic);
  void SubscribeCameraInfo(const std::string& name);
  void SubscribeOdometry(const std::string& name);
  bool IsComplete() const;

  CameraTopicOptions options_;
  bool needs_camera_info_;
  ros::NodeHandle node_;
  CameraCallbacks callbacks_;
  image_transport::ImageTransport transports_;
  image_transport::Subscriber images_;
  ros::Subscriber compressed_, camera_info_, odom_;
  std::optional<std::string> image_base_;
  ros::SteadyTime last_search_;
};

}  // namespace rovio_sfm
