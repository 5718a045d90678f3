#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "rovio_sfm/rovio/rovio_protocol.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Geometry, scale and uncertainty of the wheels. Base: x forward, y left, yaw to the left.
struct OmniOdometryOptions {
  double wheel_distance_m = 0.145;
  double front_roll_angle_rad = 0.52359877559829887;  // 30 deg
  double ticks_per_m = 465.0;
  std::array<int, 3> wheel_sign = {1, 1, 1};
  double forward_scale = 1.0;
  double sideways_scale = 1.0;
  double rotation_scale = 1.0;
  double forward_gain_sigma = 0.05;
  double sideways_gain_sigma = 0.25;  // omni wheels slip sideways
  double rotation_gain_sigma = 0.05;
  double forward_noise_m_per_sqrt_m = 0.01;
  double sideways_noise_m_per_sqrt_m = 0.03;
  double rotation_noise_rad_per_sqrt_rad = 0.02;
  double heading_noise_rad_per_sqrt_m = 0.02;
  double tick_sigma = 0.7;
  double lost_report_speed_m_per_s = 0.3;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("wheel_distance_m", wheel_distance_m, 0.02, 1.0, "from the robot's centre");
    table.AddDegrees("front_roll_angle_deg", front_roll_angle_rad, 0.01, 85.0, "off forward");
    table.AddNumber("ticks_per_m", ticks_per_m, 10.0, 1e5, "along a wheel's rim");
    // +1 when direction byte 0x02 means: front wheels backward, rear wheel to the right.
    table.AddNumbers("wheel_sign", wheel_sign, -1, 1, "left, right, rear");
    table.AddRule("wheel_sign", wheel_sign[0] * wheel_sign[1] * wheel_sign[2] != 0,
                  "three times 1 or -1");
    table.AddNumber("forward_scale", forward_scale, 0.2, 5.0, "true over computed motion");
    table.AddNumber("sideways_scale", sideways_scale, 0.2, 5.0, "true over computed motion");
    table.AddNumber("rotation_scale", rotation_scale, 0.2, 5.0, "true over computed motion");
    const char* const gain = "one sigma of the constant gain of a whole drive";
    table.AddNumber("forward_gain_sigma", forward_gain_sigma, 0.0, 1.0, gain);
    table.AddNumber("sideways_gain_sigma", sideways_gain_sigma, 0.0, 1.0, gain);
    table.AddNumber("rotation_gain_sigma", rotation_gain_sigma, 0.0, 1.0, gain);
    const char* const walk = "random walk: sigma after one metre, or one radian";
    table.AddNumber("forward_noise_m_per_sqrt_m", forward_noise_m_per_sqrt_m, 0.0, 1.0, walk);
    table.AddNumber("sideways_noise_m_per_sqrt_m", sideways_noise_m_per_sqrt_m, 0.0, 1.0, walk);
    table.AddNumber("rotation_noise_rad_per_sqrt_rad", rotation_noise_rad_per_sqrt_rad, 0.0, 1.0,
                    walk);
    table.AddNumber("heading_noise_rad_per_sqrt_m", heading_noise_rad_per_sqrt_m, 0.0, 1.0, walk);
    table.AddNumber("tick_sigma", tick_sigma, 0.0, 100.0, "of a moving wheel, quantised or lost");
    table.AddNumber("lost_report_speed_m_per_s", lost_report_speed_m_per_s, 0.0, 5.0,
                    "motion that a lost reading may have hidden");
  }
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
