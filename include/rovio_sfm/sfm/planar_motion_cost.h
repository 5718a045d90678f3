#pragma once

#include <Eigen/Geometry>

#include "rovio_sfm/sfm/reprojection_cost.h"

namespace rovio_sfm {

// Two residuals: the floor's normal as the robot's base sees it, against the base's z axis turned
// by the mount's tilt; (x, y of base_from_map * normal - tilt) / sigma_rad. Blocks: pose
// (kPoseSize), normal (3, length 1), tilt (2, radians). Analytic Jacobians; the pose's is that of
// MakeReprojectionCost. The caller owns the result.
ceres::CostFunction* MakeTiltCost(const Eigen::Quaterniond& base_from_cam, double sigma_rad);

// One residual: how far a point that stands still in the camera lies above the plane normal . x =
// offset, / sigma; all in map units. Blocks: pose (kPoseSize), normal (3, length 1), offset (1).
// Analytic Jacobians; the pose's is that of MakeReprojectionCost. The caller owns the result.
ceres::CostFunction* MakeHeightCost(const Eigen::Vector3d& x_in_cam, double sigma);

}  // namespace rovio_sfm
