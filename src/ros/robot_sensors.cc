#include "rovio_sfm/ros/robot_sensors.h"

#include <tf2/exceptions.h>

#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {
namespace {

int64_t DurationNs(double seconds) { return static_cast<int64_t>(seconds * 1e9); }

}  // namespace

bool SensorOptions::IsValid(std::string* error) const {
  OptionChecker checker("sensors", error);
  checker.Range("image_latency_s", image_latency_s, -1.0, 1.0);
  checker.Range("odom_latency_s", odom_latency_s, -1.0, 1.0);
  checker.Range("max_odom_gap_s", max_odom_gap_s, 0.01, 10.0);
  checker.Range("odom_memory_s", odom_memory_s, 1.0, 1e6);
  return checker.Passed();
}

RobotSensors::RobotSensors(const SensorOptions& options, const tf2::BufferCore* transforms)
    : options_(options),
      transforms_(transforms),
      odometry_(DurationNs(options.odom_memory_s), DurationNs(options.max_odom_gap_s)) {}

bool RobotSensors::AddOdometry(const nav_msgs::Odometry& message, std::string* error) {
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

bool RobotSensors::OdometryCovers(const std_msgs::Header& image) const {
  return odometry_.Covers(ToNanoseconds(image.stamp) - DurationNs(options_.image_latency_s));
}

bool RobotSensors::KnowsHead(const std_msgs::Header& image) const {
  return HeadAt(image).has_value();
}

std::optional<Rigid3> RobotSensors::HeadAt(const std_msgs::Header& image) const {
  const int64_t taken_ns = ToNanoseconds(image.stamp) - DurationNs(options_.image_latency_s);
  const ros::Time taken = ToTime(taken_ns);
  if (image.frame_id.empty()) return std::nullopt;  // tf2 complains aloud about empty names
  if (!transforms_->canTransform(options_.base_frame, image.frame_id, taken)) return std::nullopt;
  try {
    std::string error;
    return FromTransform(
        transforms_->lookupTransform(options_.base_frame, image.frame_id, taken).transform, &error);
  } catch (const tf2::TransformException&) {  // forgotten between the two calls
    return std::nullopt;
  }
}

ImageEvent RobotSensors::MakeEvent(const std_msgs::Header& header, const std::string& name,
                                   ImageBytes bytes) const {
  ROVIO_CHECK(HasCamera(), "an image event needs a camera");
  ImageEvent event;
  event.stamp_ns = ToNanoseconds(header.stamp);
  event.name = name;
  event.encoded = std::move(bytes);
  event.camera = *camera_;
  event.odometry = odometry_.At(event.stamp_ns - DurationNs(options_.image_latency_s));
  event.base_from_camera = HeadAt(header);
  return event;
}

}  // namespace rovio_sfm
