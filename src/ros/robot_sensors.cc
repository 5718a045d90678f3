#include "rovio_sfm/ros/robot_sensors.h"

#include <tf2/exceptions.h>

#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

int64_t DurationNs(double seconds) { return static_cast<int64_t>(seconds * 1e9); }

}  // namespace

RobotSensors::RobotSensors(const SensorOptions& options, const tf2::BufferCore* transforms)
    : options_(options),
      transforms_(transforms),
      odometry_(DurationNs(options.odom_memory_s), DurationNs(options.max_odom_gap_s)) {}

bool RobotSensors::AddOdometry(const nav_msgs::Odometry& message, std::string* error) {
  if (message.header.stamp.isZero()) {
    *error = "header.stamp: zero";
    return false;
  }
  const std::optional<OdometrySample> sample = FromOdometry(message, error);
  if (!sample) return false;
  const int64_t stamp_ns = ToNanoseconds(message.header.stamp);
  odometry_.Add({stamp_ns - DurationNs(options_.odom_latency_s), *sample});
  return true;
}

bool RobotSensors::AddCameraInfo(const sensor_msgs::CameraInfo& message, std::string* error) {
  const std::optional<Camera> camera = FromCameraInfo(message, error);
  if (camera) camera_ = camera;
  return camera.has_value();
}

bool RobotSensors::OdometryCovers(const RawImage& image) const {
  return odometry_.Covers(image.stamp_ns - DurationNs(options_.image_latency_s));
}

bool RobotSensors::HasHead(const RawImage& image) const {
  return HasTransform(CameraFrameOf(image), ros::Time());  // the newest
}

bool RobotSensors::KnowsHead(const RawImage& image) const { return HeadAt(image).has_value(); }

const std::string& RobotSensors::CameraFrameOf(const RawImage& image) const {
  return options_.camera_frame.empty() ? image.camera_frame : options_.camera_frame;
}

// tf2 complains aloud about empty names.
bool RobotSensors::HasTransform(const std::string& camera_frame, const ros::Time& time) const {
  return !camera_frame.empty() &&
         transforms_->canTransform(options_.base_frame, camera_frame, time);
}

std::optional<Rigid3> RobotSensors::HeadAt(const RawImage& image) const {
  const std::string& camera_frame = CameraFrameOf(image);
  const int64_t taken_ns = image.stamp_ns - DurationNs(options_.image_latency_s);
  const ros::Time taken = ToTime(taken_ns);
  if (!HasTransform(camera_frame, taken)) return std::nullopt;
  try {
    std::string error;
    return FromTransform(
        transforms_->lookupTransform(options_.base_frame, camera_frame, taken).transform, &error);
  } catch (const tf2::TransformException&) {  // forgotten between the two calls
    return std::nullopt;
  }
}

ImageEvent RobotSensors::MakeEvent(const RawImage& image) const {
  ROVIO_CHECK(HasCamera(), "an image event needs a camera");
  ImageEvent event;
  event.stamp_ns = image.stamp_ns;
  event.name = image.name;
  event.camera_frame = CameraFrameOf(image);
  event.encoded = image.bytes;
  event.camera = *camera_;
  event.odometry = odometry_.At(event.stamp_ns - DurationNs(options_.image_latency_s));
  event.base_from_camera = HeadAt(image);
  return event;
}

}  // namespace rovio_sfm
