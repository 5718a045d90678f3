#include "rovio_sfm/sfm/odometry_gate.h"

#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

double AngleDeg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return Degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

}  // namespace

std::optional<Rigid3> OdomFromCamera(const std::optional<OdometrySample>& odometry,
                                     const std::optional<Rigid3>& base_from_camera) {
  if (!odometry || !base_from_camera) return std::nullopt;
  const Eigen::AngleAxisd heading(odometry->yaw_rad, Eigen::Vector3d::UnitZ());
  const Rigid3 odom_from_base{Eigen::Quaterniond(heading), {odometry->x_m, odometry->y_m, 0.0}};
  return odom_from_base * *base_from_camera;
}

bool PassesOdometryGate(const PairMatches& pair, const Rigid3& odom_from_other,
                        const Rigid3& odom_from_camera, const OdometryGateOptions& options) {
  if (!options.enabled) return true;
  const Rigid3 by_wheels = Inverse(odom_from_camera) * odom_from_other;  // camera from other
  const Rigid3& by_camera = pair.cam_from_other;
  const double rotation_gap_deg =
      Degrees(RotationAngle(by_wheels.rotation * by_camera.rotation.conjugate()));
  if (rotation_gap_deg > options.max_rotation_gap_deg) return false;
  const bool has_direction =
      by_wheels.translation.norm() >= options.min_distance_m && by_camera.translation.norm() > 0.0;
  return !has_direction ||
         AngleDeg(by_wheels.translation, by_camera.translation) <= options.max_direction_gap_deg;
}

}  // namespace rovio_sfm
