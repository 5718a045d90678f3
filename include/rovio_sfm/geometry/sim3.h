#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// A similarity b_from_a: x_in_b = scale * (rotation * x_in_a) + translation, scale > 0.
struct Sim3 {
  double scale = 1.0;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

inline bool operator==(const Sim3& x, const Sim3& y) {  // the same numbers
  return x.scale == y.scale && x.rotation.coeffs() == y.rotation.coeffs() &&
         x.translation == y.translation;
}

inline Sim3 Inverse(const Sim3& b_from_a) {
  const Eigen::Quaterniond inverse = b_from_a.rotation.conjugate();
  return {1.0 / b_from_a.scale, inverse, inverse * -b_from_a.translation / b_from_a.scale};
}

inline Sim3 operator*(const Sim3& c_from_b, const Sim3& b_from_a) {
  return {c_from_b.scale * b_from_a.scale, (c_from_b.rotation * b_from_a.rotation).normalized(),
          c_from_b.scale * (c_from_b.rotation * b_from_a.translation) + c_from_b.translation};
}

inline Eigen::Vector3d operator*(const Sim3& b_from_a, const Eigen::Vector3d& x_in_a) {
  return b_from_a.scale * (b_from_a.rotation * x_in_a) + b_from_a.translation;
}

// The pose cam_from_b of a camera whose pose in a is cam_from_a; lengths become those of b.
inline Rigid3 TransformCamera(const Sim3& b_from_a, const Rigid3& cam_from_a) {
  const Eigen::Quaterniond rotation = cam_from_a.rotation * b_from_a.rotation.conjugate();
  return {rotation, b_from_a.scale * cam_from_a.translation - rotation * b_from_a.translation};
}

// The similarity that maps points_in_a onto points_in_b with the least squared error (Umeyama
// 1991). Nothing for fewer than 3 points, unequal counts, or points on one line.
std::optional<Sim3> AlignPoints(const std::vector<Eigen::Vector3d>& points_in_a,
                                const std::vector<Eigen::Vector3d>& points_in_b);

}  // namespace rovio_sfm
