#include "rovio_sfm/ros/conversions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rovio_sfm/geometry/check_calibration.h"
#include "rovio_sfm/ros/check_transform.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kNanosecondsPerSecond = 1000000000;
constexpr std::array<size_t, 3> kPlanarAxes = {0, 1, 5};  // x, y and yaw of a 6-vector
// In messages, as REP-145 marks it; a negative variance means nothing else.
constexpr OdometryCovariance kUnknownCovariance = {-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

template <typename Array>
bool AllFinite(const Array& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

template <typename T>
std::optional<T> RefuseMessage(const std::string& reason, std::string* error) {
  *error = reason;
  return std::nullopt;
}

Eigen::Quaterniond ToEigen(const geometry_msgs::Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

geometry_msgs::Quaternion ToQuaternion(const Eigen::Quaterniond& q) {
  geometry_msgs::Quaternion message;
  message.w = q.w();
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  return message;
}

double YawOf(const Eigen::Quaterniond& q) {
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()),
                    1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

using PlumbBob = std::array<double, 5>;  // k1 k2 p1 p2 k3

// What a rational polynomial adds are k4, k5, k6 and more behind the five of a plumb bob: the two
// are one where those are zero.
std::optional<PlumbBob> PlumbBobOf(const sensor_msgs::CameraInfo& message, std::string* error) {
  const std::string& model = message.distortion_model;
  const bool is_known = model == "plumb_bob" || model == "rational_polynomial";
  const auto beyond =
      message.D.begin() + static_cast<std::ptrdiff_t>(std::min<size_t>(5, message.D.size()));
  const bool is_plumb_bob =
      std::all_of(beyond, message.D.end(), [](double value) { return value == 0.0; });
  if ((!is_known && !message.D.empty()) || !is_plumb_bob) {
    return RefuseMessage<PlumbBob>("camera_info distortion_model " + model + " with " +
                                       std::to_string(message.D.size()) +
                                       " numbers in D: expected plumb_bob, at most 5 not zero",
                                   error);
  }
  PlumbBob d{};
  std::copy(message.D.begin(), beyond, d.begin());
  return d;
}

// A region of interest of zeros, or of the whole image, is none.
bool ShowsWholeImage(const sensor_msgs::CameraInfo& message, std::string* error) {
  const sensor_msgs::RegionOfInterest& roi = message.roi;
  const bool is_none = roi.width == 0 && roi.height == 0;
  const bool is_whole = roi.width == message.width && roi.height == message.height;
  const bool has_offset = roi.x_offset != 0 || roi.y_offset != 0;
  if (message.binning_x <= 1 && message.binning_y <= 1 && (is_none || is_whole) && !has_offset) {
    return true;
  }
  *error = "camera_info roi " + std::to_string(roi.width) + "x" + std::to_string(roi.height) + "+" +
           std::to_string(roi.x_offset) + "+" + std::to_string(roi.y_offset) + ", binning " +
           std::to_string(message.binning_x) + "x" + std::to_string(message.binning_y) +
           ": expected the whole image, " + std::to_string(message.width) + "x" +
           std::to_string(message.height);
  return false;
}

}  // namespace

ros::Time ToTime(int64_t stamp_ns) {
  constexpr int64_t kMaxSeconds = std::numeric_limits<uint32_t>::max();
  const int64_t clamped = std::clamp<int64_t>(stamp_ns, 0, kMaxSeconds * kNanosecondsPerSecond);
  return {static_cast<uint32_t>(clamped / kNanosecondsPerSecond),
          static_cast<uint32_t>(clamped % kNanosecondsPerSecond)};
}

int64_t ToNanoseconds(const ros::Time& time) {
  return static_cast<int64_t>(time.sec) * kNanosecondsPerSecond + static_cast<int64_t>(time.nsec);
}

geometry_msgs::Transform ToTransform(const Rigid3& b_from_a) {
  geometry_msgs::Transform message;
  message.translation.x = b_from_a.translation.x();
  message.translation.y = b_from_a.translation.y();
  message.translation.z = b_from_a.translation.z();
  message.rotation = ToQuaternion(b_from_a.rotation);
  return message;
}

geometry_msgs::Pose ToPose(const Rigid3& b_from_a) {
  geometry_msgs::Pose message;
  message.position.x = b_from_a.translation.x();
  message.position.y = b_from_a.translation.y();
  message.position.z = b_from_a.translation.z();
  message.orientation = ToQuaternion(b_from_a.rotation);
  return message;
}

std::optional<Rigid3> FromTransform(const geometry_msgs::Transform& message, std::string* error) {
  const std::string reason = WhyNoTransform(message);
  if (!reason.empty()) return RefuseMessage<Rigid3>(reason, error);
  const auto& t = message.translation;
  return Rigid3{ToEigen(message.rotation).normalized(), Eigen::Vector3d(t.x, t.y, t.z)};
}

CameraMsg ToMessage(const Camera& camera) {
  CameraMsg message;
  message.fx_px = camera.fx;
  message.fy_px = camera.fy;
  message.cx_px = camera.cx;
  message.cy_px = camera.cy;
  message.k1 = camera.k1;
  message.k2 = camera.k2;
  message.p1 = camera.p1;
  message.p2 = camera.p2;
  message.k3 = camera.k3;
  message.width = static_cast<uint32_t>(camera.width);
  message.height = static_cast<uint32_t>(camera.height);
  return message;
}

std::optional<Camera> FromMessage(const CameraMsg& message, std::string* error) {
  Camera camera;
  camera.fx = message.fx_px;
  camera.fy = message.fy_px;
  camera.cx = message.cx_px;
  camera.cy = message.cy_px;
  camera.k1 = message.k1;
  camera.k2 = message.k2;
  camera.p1 = message.p1;
  camera.p2 = message.p2;
  camera.k3 = message.k3;
  camera.width = static_cast<int>(std::min<uint32_t>(message.width, 1u << 30));
  camera.height = static_cast<int>(std::min<uint32_t>(message.height, 1u << 30));
  if (!IsValidCalibration(camera, error)) return std::nullopt;
  return camera;
}

std::optional<Camera> FromCameraInfo(const sensor_msgs::CameraInfo& message, std::string* error) {
  if (message.K[0] == 0.0)
    return RefuseMessage<Camera>("camera_info K: uncalibrated (zeros)", error);
  const std::optional<PlumbBob> d = PlumbBobOf(message, error);
  if (!d) return std::nullopt;
  if (!ShowsWholeImage(message, error)) return std::nullopt;
  CameraMsg camera;
  camera.fx_px = message.K[0];
  camera.fy_px = message.K[4];
  camera.cx_px = message.K[2];
  camera.cy_px = message.K[5];
  camera.k1 = (*d)[0];
  camera.k2 = (*d)[1];
  camera.p1 = (*d)[2];
  camera.p2 = (*d)[3];
  camera.k3 = (*d)[4];
  camera.width = message.width;
  camera.height = message.height;
  return FromMessage(camera, error);
}

sensor_msgs::CameraInfo ToCameraInfo(const Camera& camera, int64_t stamp_ns,
                                     const std::string& frame_id) {
  sensor_msgs::CameraInfo message;
  message.header.stamp = ToTime(stamp_ns);
  message.header.frame_id = frame_id;
  message.width = static_cast<uint32_t>(camera.width);
  message.height = static_cast<uint32_t>(camera.height);
  message.distortion_model = "plumb_bob";
  message.D = {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3};
  message.K = {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  message.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  message.P = {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return message;
}

OdometrySampleMsg ToMessage(const OdometrySample& sample) {
  OdometrySampleMsg message;
  message.x_m = sample.x_m;
  message.y_m = sample.y_m;
  message.yaw_rad = sample.yaw_rad;
  const OdometryCovariance covariance = sample.covariance.value_or(kUnknownCovariance);
  std::copy(covariance.begin(), covariance.end(), message.covariance.begin());
  return message;
}

std::optional<OdometrySample> FromMessage(const OdometrySampleMsg& message, std::string* error) {
  if (!AllFinite(std::array<double, 3>{message.x_m, message.y_m, message.yaw_rad})) {
    return RefuseMessage<OdometrySample>("x_m, y_m or yaw_rad is not finite", error);
  }
  OdometrySample sample{message.x_m, message.y_m, message.yaw_rad};
  OdometryCovariance c;
  std::copy(message.covariance.begin(), message.covariance.end(), c.begin());
  if (c == kUnknownCovariance) return sample;
  if (!AllFinite(c) || c[0] < 0.0 || c[4] < 0.0 || c[8] < 0.0) {
    return RefuseMessage<OdometrySample>("covariance: not finite or a negative variance", error);
  }
  sample.covariance = c;
  return sample;
}

Rigid3 OdomFromBase(const OdometrySample& sample) {
  const Eigen::AngleAxisd yaw(sample.yaw_rad, Eigen::Vector3d::UnitZ());
  return {Eigen::Quaterniond(yaw), {sample.x_m, sample.y_m, 0.0}};
}

std::optional<OdometrySample> FromOdometry(const nav_msgs::Odometry& message, std::string* error) {
  const auto& pose = message.pose.pose;
  const Eigen::Quaterniond rotation = ToEigen(pose.orientation);
  if (!(std::abs(rotation.norm() - 1.0) < 1e-3)) {
    return RefuseMessage<OdometrySample>("odom pose.orientation: the norm is not 1", error);
  }
  OdometrySampleMsg planar;
  planar.x_m = pose.position.x;
  planar.y_m = pose.position.y;
  planar.yaw_rad = YawOf(rotation);
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      planar.covariance[3 * row + column] =
          message.pose.covariance[6 * kPlanarAxes[row] + kPlanarAxes[column]];
    }
  }
  auto& c = planar.covariance;
  if (c[0] < 0.0 || c[4] < 0.0 || c[8] < 0.0) {
    std::copy(kUnknownCovariance.begin(), kUnknownCovariance.end(), c.begin());
  }
  std::string reason;
  std::optional<OdometrySample> sample = FromMessage(planar, &reason);
  if (!sample) *error = "odom pose: " + reason;
  return sample;
}

nav_msgs::Odometry ToOdometry(const OdometrySample& sample, int64_t stamp_ns,
                              const std::string& odom_frame, const std::string& base_frame) {
  nav_msgs::Odometry message;
  message.header.stamp = ToTime(stamp_ns);
  message.header.frame_id = odom_frame;
  message.child_frame_id = base_frame;
  message.pose.pose = ToPose(OdomFromBase(sample));
  const OdometryCovariance covariance = sample.covariance.value_or(kUnknownCovariance);
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      message.pose.covariance[6 * kPlanarAxes[row] + kPlanarAxes[column]] =
          covariance[3 * row + column];
    }
  }
  message.twist.covariance[0] = -1.0;  // unknown, as REP-145 has it
  return message;
}

DriveIdMsg ToMessage(const DriveId& id) {
  DriveIdMsg message;
  message.robot = id.robot;
  message.start = ToTime(id.start_ns);
  message.nonce = id.nonce;
  return message;
}

std::optional<DriveId> FromMessage(const DriveIdMsg& message, std::string* error) {
  if (!IsValidRobotName(message.robot, error)) return std::nullopt;
  return DriveId{message.robot, ToNanoseconds(message.start), message.nonce};
}

FrameIdMsg ToMessage(const FrameId& id) {
  FrameIdMsg message;
  message.drive = ToMessage(id.drive);
  message.index = id.index;
  return message;
}

std::optional<FrameId> FromMessage(const FrameIdMsg& message, std::string* error) {
  const std::optional<DriveId> drive = FromMessage(message.drive, error);
  if (!drive) return std::nullopt;
  return FrameId{*drive, message.index};
}

}  // namespace rovio_sfm
