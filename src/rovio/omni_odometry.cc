#include "rovio_sfm/rovio/omni_odometry.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace rovio_sfm {
namespace {

constexpr int kBackwardBit = 0x02;
constexpr double kSmallYaw = 1e-9;

// Row i: travel of wheel i's rim per unit of forward, left and yaw motion. Positive rim travel is
// forward for the front wheels and to the left for the rear wheel (Rogers' signs).
Eigen::Matrix3d RimFromMotion(const OmniOdometryOptions& options) {
  const double along = std::cos(options.front_roll_angle_rad);
  const double across = std::sin(options.front_roll_angle_rad);
  const double distance = options.wheel_distance_m;
  Eigen::Matrix3d rim_from_motion;
  rim_from_motion << along, -across, -distance,  // left
      along, across, distance,                   // right
      0.0, 1.0, -distance;                       // rear
  return rim_from_motion;
}

// The displacement of the base, in the base at the start, when it moves with constant velocity.
Eigen::Vector2d Displacement(const BaseMotion& motion) {
  const double yaw = motion.z();
  const double a = std::abs(yaw) < kSmallYaw ? 1.0 : std::sin(yaw) / yaw;
  const double b = std::abs(yaw) < kSmallYaw ? yaw / 2.0 : (1.0 - std::cos(yaw)) / yaw;
  return {a * motion.x() - b * motion.y(), b * motion.x() + a * motion.y()};
}

double Square(double x) { return x * x; }

}  // namespace

OmniOdometry::OmniOdometry(const OmniOdometryOptions& options)
    : options_(options), motion_from_rim_(RimFromMotion(options).inverse()) {
  covariance_(3, 3) = Square(options.forward_gain_sigma);
  covariance_(4, 4) = Square(options.sideways_gain_sigma);
  covariance_(5, 5) = Square(options.rotation_gain_sigma);
}

BaseMotion OmniOdometry::MotionFromTicks(const std::array<WheelTicks, 3>& wheels) const {
  Eigen::Vector3d rim_m;
  for (int i = 0; i < 3; ++i) {
    const WheelTicks& wheel = wheels[static_cast<size_t>(i)];
    const int sense = (wheel.direction & kBackwardBit) != 0 ? -1 : 1;
    rim_m[i] =
        sense * options_.wheel_sign[static_cast<size_t>(i)] * wheel.ticks / options_.ticks_per_m;
  }
  const Eigen::Vector3d scale(options_.forward_scale, options_.sideways_scale,
                              options_.rotation_scale);
  return (motion_from_rim_ * rim_m).cwiseProduct(scale);
}

BaseMotion OmniOdometry::Add(const std::array<WheelTicks, 3>& wheels) {
  const BaseMotion motion = MotionFromTicks(wheels);
  Propagate(motion, NoiseOf(motion, wheels));
  return motion;
}

Eigen::Matrix3d OmniOdometry::NoiseOf(const BaseMotion& motion,
                                      const std::array<WheelTicks, 3>& wheels) const {
  Eigen::Vector3d rim_variance = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    if (wheels[static_cast<size_t>(i)].ticks == 0) continue;
    rim_variance[i] = Square(options_.tick_sigma / options_.ticks_per_m);
  }
  Eigen::Matrix3d noise =
      motion_from_rim_ * rim_variance.asDiagonal() * motion_from_rim_.transpose();
  const double distance_m = motion.head<2>().norm();
  noise(0, 0) += Square(options_.forward_noise_m_per_sqrt_m) * std::abs(motion.x());
  noise(1, 1) += Square(options_.sideways_noise_m_per_sqrt_m) * std::abs(motion.y());
  noise(2, 2) += Square(options_.rotation_noise_rad_per_sqrt_rad) * std::abs(motion.z()) +
                 Square(options_.heading_noise_rad_per_sqrt_m) * distance_m;
  return noise;
}

void OmniOdometry::AddLostReading(double duration_s) {
  const double distance_m = options_.lost_report_speed_m_per_s * duration_s;
  const double angle_rad = distance_m / options_.wheel_distance_m;
  Propagate(
      BaseMotion::Zero(),
      Eigen::Vector3d(Square(distance_m), Square(distance_m), Square(angle_rad)).asDiagonal());
}

// First-order propagation of pose and gains: the gains multiply the motion and never change.
void OmniOdometry::Propagate(const BaseMotion& motion, const Eigen::Matrix3d& motion_noise) {
  const double middle_yaw = state_.yaw_rad + motion.z() / 2.0;
  Eigen::Matrix3d odom_from_motion = Eigen::Matrix3d::Identity();
  odom_from_motion.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(middle_yaw).toRotationMatrix();
  const Eigen::Vector2d step =
      Eigen::Rotation2Dd(state_.yaw_rad).toRotationMatrix() * Displacement(motion);

  Matrix6 transition = Matrix6::Identity();
  transition(0, 2) = -step.y();
  transition(1, 2) = step.x();
  transition.topRightCorner<3, 3>() = odom_from_motion * motion.asDiagonal();
  covariance_ = transition * covariance_ * transition.transpose();
  covariance_.topLeftCorner<3, 3>() +=
      odom_from_motion * motion_noise * odom_from_motion.transpose();

  state_.x_m += step.x();
  state_.y_m += step.y();
  state_.yaw_rad += motion.z();
  state_.covariance = covariance_.topLeftCorner<3, 3>();
}

}  // namespace rovio_sfm
