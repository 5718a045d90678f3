#pragma once

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "rovio_sfm/app/image_gate.h"
#include "rovio_sfm/app/odometry_buffer.h"
#include "rovio_sfm/app/sensor_options.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// What a robot said about its camera and its motion, put together for an image: the same for a live
// robot and a bag. Not thread-safe; the transforms are borrowed.
class RobotSensors : public RobotKnowledge {
 public:
  RobotSensors(const SensorOptions& options, const tf2::BufferCore* transforms);

  // Both refuse malformed messages; error names the field.
  bool AddOdometry(const nav_msgs::Odometry& message, std::string* error);
  bool AddCameraInfo(const sensor_msgs::CameraInfo& message, std::string* error);

  // Known before any camera_info: from a file.
  void SetCamera(const Camera& camera) { camera_ = camera; }

  bool HasCamera() const override { return camera_.has_value(); }
  bool HasOdometry() const override { return !odometry_.IsEmpty(); }
  bool HasHead(const RawImage& image) const override;
  bool OdometryCovers(const RawImage& image) const override;
  bool KnowsHead(const RawImage& image) const override;
  ImageEvent MakeEvent(const RawImage& image) const override;

 private:
  const std::string& CameraFrameOf(const RawImage& image) const;
  bool HasTransform(const std::string& camera_frame, const ros::Time& time) const;
  std::optional<Rigid3> HeadAt(const RawImage& image) const;

  SensorOptions options_;
  const tf2::BufferCore* transforms_;
  OdometryBuffer odometry_;
  std::optional<Camera> camera_;
};

}  // namespace rovio_sfm
