#include "rovio_sfm/sim/robot/omni_wheels.h"

#include <Eigen/LU>
#include <cmath>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

// Rows: left, right, rear wheel; columns: forward, left, turn. The wheels stand at +60, -60 and 180
// deg around the middle and roll along the circle; a rim travels as its hub does along that way.
Eigen::Matrix3d RimFromBody(const OmniGeometry& geometry) {
  const double c = std::cos(geometry.wheel_angle_rad), s = std::sin(geometry.wheel_angle_rad);
  const double d = geometry.center_distance_m;
  Eigen::Matrix3d rim_from_body;
  rim_from_body << c, -s, -d,  //
      c, s, d,                 //
      0, 1, -d;
  return rim_from_body;
}

// Adds the uncertainty of one small motion: slip in proportion to the way, most of it sideways.
Eigen::Matrix3d StepCovariance(const BodyMotion& step, double yaw_rad) {
  const double way = std::hypot(step.forward_m, step.left_m);
  const double sigma_forward = 0.05, sigma_side = 0.25;
  const double forward = sigma_forward * std::abs(step.forward_m) + 0.02 * way;
  const double side = sigma_side * std::abs(step.left_m) + 0.02 * way;
  const double turn_variance = 0.02 * 0.02 * way + std::pow(0.03 * step.turn_rad, 2);
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  Eigen::Matrix3d rotation;
  rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  const Eigen::Vector3d variance(forward * forward, side * side, turn_variance);
  return rotation * variance.asDiagonal() * rotation.transpose();
}

}  // namespace

bool SlipOptions::IsValid(std::string* error) const {
  OptionChecker check("slip", error);
  check.Range("forward_gain_spread", forward_gain_spread, 0.0, 0.5);
  check.Range("min_side_loss", min_side_loss, 0.0, 0.9);
  check.Range("max_side_loss", max_side_loss, min_side_loss, 0.9);
  check.Range("heading_walk_rad_per_sqrt_m", heading_walk_rad_per_sqrt_m, 0.0, 1.0);
  check.Range("lost_tick_share", lost_tick_share, 0.0, 0.5);
  return check.Passed();
}

std::array<double, 3> RimTravel(const BodyMotion& motion, const OmniGeometry& geometry) {
  const Eigen::Vector3d rim =
      RimFromBody(geometry) * Eigen::Vector3d(motion.forward_m, motion.left_m, motion.turn_rad);
  return {rim[0], rim[1], rim[2]};
}

BodyMotion MotionFromRim(const std::array<double, 3>& rim_m, const OmniGeometry& geometry) {
  const Eigen::Vector3d body =
      RimFromBody(geometry).inverse() * Eigen::Vector3d(rim_m[0], rim_m[1], rim_m[2]);
  return {body[0], body[1], body[2]};
}

Slip DrawSlip(const SlipOptions& options, Rng& rng) {
  const double spread = options.forward_gain_spread;
  Slip slip;
  slip.forward_gain = 1.0 + rng.Uniform(-spread, spread);
  slip.side_gain = 1.0 - rng.Uniform(options.min_side_loss, options.max_side_loss);
  slip.turn_gain = 1.0 + rng.Uniform(-spread, spread);
  return slip;
}

TickCounter::TickCounter(const OmniGeometry& geometry, double lost_tick_share, Rng rng)
    : geometry_(geometry), lost_tick_share_(lost_tick_share), rng_(rng) {}

std::array<int, 3> TickCounter::Add(const std::array<double, 3>& rim_m) {
  std::array<int, 3> counted{};
  for (size_t wheel = 0; wheel < 3; ++wheel) {
    fraction_[wheel] += rim_m[wheel] * geometry_.ticks_per_m;
    const int whole = static_cast<int>(fraction_[wheel]);
    fraction_[wheel] -= whole;
    const int sign = whole < 0 ? -1 : 1;
    for (int i = 0; i < std::abs(whole); ++i) {
      if (rng_.Uniform() >= lost_tick_share_) counted[wheel] += sign;
    }
  }
  return counted;
}

void TickIntegrator::Add(const std::array<int, 3>& ticks) {
  std::array<double, 3> rim_m{};
  for (size_t wheel = 0; wheel < 3; ++wheel) rim_m[wheel] = ticks[wheel] / geometry_.ticks_per_m;
  const BodyMotion step = MotionFromRim(rim_m, geometry_);
  const double heading = pose_[2] + 0.5 * step.turn_rad;
  const double c = std::cos(heading), s = std::sin(heading);
  const Eigen::Vector2d moved(c * step.forward_m - s * step.left_m,
                              s * step.forward_m + c * step.left_m);
  Eigen::Matrix3d step_from_pose = Eigen::Matrix3d::Identity();
  step_from_pose(0, 2) = -moved.y();
  step_from_pose(1, 2) = moved.x();
  covariance_ =
      step_from_pose * covariance_ * step_from_pose.transpose() + StepCovariance(step, heading);
  pose_ += Eigen::Vector3d(moved.x(), moved.y(), step.turn_rad);
}

}  // namespace rovio_sfm::sim
