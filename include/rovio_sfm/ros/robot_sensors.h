#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "rovio_sfm/pipeline/events.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/odometry_buffer.h"

namespace rovio_sfm {

struct SensorOptions {
  std::string base_frame;        // tf frame of the robot's body; empty: <robot>/base_link
  double image_latency_s = 0.0;  // an image was taken so long before its stamp; -1 to 1
  double odom_latency_s = 0.0;   // so was an odometry sample; -1 to 1
  double max_odom_gap_s = 0.5;   // wider gaps are not interpolated; 0.01 to 10
  double odom_memory_s = 20.0;   // how long odometry is kept; 1 to 1e6

  bool IsValid(std::string* error) const;
};

// What a robot said about its camera and its motion, put together for an image: the same for a live
// robot and a bag. Not thread-safe; the transforms are borrowed.
class RobotSensors {
 public:
  RobotSensors(const SensorOptions& options, const tf2::BufferCore* transforms);

  // Both refuse malformed messages; error names the field.
  bool AddOdometry(const nav_msgs::Odometry& message, std::string* error);
  bool AddCameraInfo(const sensor_msgs::CameraInfo& message, std::string* error);

  bool HasCamera() const { return camera_.has_value(); }
  bool HasOdometry() const { return !odometry_.IsEmpty(); }
  // True if later odometry or transforms would not add to what is known at the image's stamp.
  bool OdometryCovers(const std_msgs::Header& image) const;
  bool KnowsHead(const std_msgs::Header& image) const;

  // The event of an image, with whatever is known at its stamp. Needs HasCamera().
  ImageEvent MakeEvent(const std_msgs::Header& header, const std::string& name,
                       ImageBytes bytes) const;

 private:
  std::optional<Rigid3> HeadAt(const std_msgs::Header& image) const;

  SensorOptions options_;
  const tf2::BufferCore* transforms_;
  OdometryBuffer odometry_;
  std::optional<Camera> camera_;
};

}  // namespace rovio_sfm
