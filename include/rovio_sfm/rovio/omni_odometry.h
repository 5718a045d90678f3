#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "rovio_sfm/rovio/rovio_protocol.h"

namespace rovio_sfm {

// Geometry, scale and uncertainty of the wheels. Base: x forward, y left, yaw to the left.
struct OmniOdometryOptions {
  double wheel_distance_m = 0.145;                    // from the robot's centre to each wheel
  double front_roll_angle_rad = 0.52359877559829887;  // 30 deg, front wheels off forward
  double ticks_per_m = 465.0;                         // along a wheel's rim
  // +1 when direction byte 0x02 means: front wheels backward, rear wheel to the right.
  std::array<int, 3> wheel_sign = {1, 1, 1};  // left, right, rear
  double forward_scale = 1.0;                 // true over computed motion, from a calibration
  double sideways_scale = 1.0;
  double rotation_scale = 1.0;

  // One standard deviation of the constant gain of a whole drive, as a share of the motion.
  double forward_gain_sigma = 0.05;
  double sideways_gain_sigma = 0.25;  // omni wheels slip sideways
  double rotation_gain_sigma = 0.05;
  // Random walk: standard deviation after one metre, or one radian.
  double forward_noise_m_per_sqrt_m = 0.01;
  double sideways_noise_m_per_sqrt_m = 0.03;
  double rotation_noise_rad_per_sqrt_rad = 0.02;
  double heading_noise_rad_per_sqrt_m = 0.02;  // turning while it should go straight
  double tick_sigma = 0.7;                 // of a wheel with motion: quantised, or lost to a reader
  double lost_report_speed_m_per_s = 0.3;  // motion that a lost reading may have hidden

  bool IsValid(std::string* error) const;
};

// Pose of the base in odom and how sure it is.
struct OdometryState {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;                                  // not wrapped
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of (x, y, yaw)
};

// Motion of the base within one interval, in the base at its start: metres, metres, radians.
using BaseMotion = Eigen::Vector3d;

// Adds up wheel ticks by the induced-velocity kinematics of three omni wheels (Ashmore and Barnes
// 2002): each wheel measures the rim velocity along its rolling direction. The unknown gains of a
// drive are kept as states of the covariance, so that it grows with the distance, not its root.
class OmniOdometry {
 public:
  explicit OmniOdometry(const OmniOdometryOptions& options);

  // The motion of the base since the last reading, from ticks.
  BaseMotion MotionFromTicks(const std::array<WheelTicks, 3>& wheels) const;

  // Moves the pose by the ticks of one reading; returns that motion.
  BaseMotion Add(const std::array<WheelTicks, 3>& wheels);

  // Tells that a reading of this length was lost while the robot was driven.
  void AddLostReading(double duration_s);

  const OdometryState& State() const { return state_; }

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  Eigen::Matrix3d NoiseOf(const BaseMotion& motion, const std::array<WheelTicks, 3>& wheels) const;
  void Propagate(const BaseMotion& motion, const Eigen::Matrix3d& motion_noise);

  const OmniOdometryOptions options_;
  const Eigen::Matrix3d motion_from_rim_;  // base motion from the three rim travels, in metres
  OdometryState state_;
  Matrix6 covariance_ = Matrix6::Zero();  // of (x, y, yaw, gain forward, sideways, rotation)
};

}  // namespace rovio_sfm
