#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace rovio_sfm {

// The similarity T that moves points to mean 0 and mean distance sqrt(2) (A.4.30; Hartley 1997), so
// that linear equations in them are well conditioned. Nothing if the points are one point or none.
std::optional<Eigen::Matrix3d> FindPointNormalization(const std::vector<Eigen::Vector2d>& points);

}  // namespace rovio_sfm
