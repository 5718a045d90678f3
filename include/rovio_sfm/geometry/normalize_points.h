#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace rovio_sfm {

// The similarity T that moves points to mean 0 and mean distance sqrt(2) (A.4.30; Hartley 1997), so
// that linear equations in them are well conditioned. Nothing if the points are one point or none.
std::optional<Eigen::Matrix3d> FindPointNormalization(const std::vector<Eigen::Vector2d>& points);

// Matched points in normalised form, homogeneous: x_a = transform_a * point_a.
struct NormalizedMatches {
  Eigen::Matrix3d transform_a, transform_b;
  std::vector<Eigen::Vector3d> x_a, x_b;
};

// Nothing if there are fewer than min_matches, if the lists differ in length, or if the points of
// one are one point.
std::optional<NormalizedMatches> NormalizeMatches(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b,
                                                  size_t min_matches);

}  // namespace rovio_sfm
