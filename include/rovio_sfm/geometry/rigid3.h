#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace rovio_sfm {

// A rigid motion b_from_a: x_in_b = rotation * x_in_a + translation. Lengths are those of the
// frames (metres or map units). Neighbours cancel: c_from_a = c_from_b * b_from_a.
struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

inline Rigid3 Inverse(const Rigid3& b_from_a) {
  const Eigen::Quaterniond inverse = b_from_a.rotation.conjugate();
  return {inverse, inverse * -b_from_a.translation};
}

inline Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a) {
  return {(c_from_b.rotation * b_from_a.rotation).normalized(),
          c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

inline Eigen::Vector3d operator*(const Rigid3& b_from_a, const Eigen::Vector3d& x_in_a) {
  return b_from_a.rotation * x_in_a + b_from_a.translation;
}

// Where the origin of b lies, in a: the camera centre for cam_from_map.
inline Eigen::Vector3d OriginInA(const Rigid3& b_from_a) {
  return b_from_a.rotation.conjugate() * -b_from_a.translation;
}

// The angle of the rotation, in [0, pi].
inline double RotationAngle(const Eigen::Quaterniond& rotation) {
  return 2.0 * std::atan2(rotation.vec().norm(), std::abs(rotation.w()));
}

}  // namespace rovio_sfm
