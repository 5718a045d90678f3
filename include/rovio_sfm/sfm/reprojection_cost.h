#pragma once

#include <Eigen/Core>
#include <array>

namespace ceres {
class CostFunction;
class Manifold;
}  // namespace ceres

namespace rovio_sfm {

// A camera as Ceres sees it: quaternion x y z w, then translation, of cam_from_map.
constexpr int kPoseSize = 7;
using PoseBlock = std::array<double, kPoseSize>;

// Two residuals, (projection - x_normalized) / sigma, of a pose block and a point block (3), with
// analytic Jacobians. The pose's Jacobian is taken in the tangent space of MakePoseManifold and put
// into the first columns, so it must be used with that manifold alone. The caller owns the result.
ceres::CostFunction* MakeReprojectionCost(const Eigen::Vector2d& x_normalized, double sigma);

// BundleIntrinsics::correction as Ceres sees it, with as many zeros as make it as large as a pose's
// tangent: Ceres is fast where all blocks but the points are.
constexpr int kIntrinsicsSize = 6;
using IntrinsicsBlock = std::array<double, kIntrinsicsSize>;

// The same with an intrinsics block as third: x_normalized moves by `by_correction` (of
// NormalizedByCorrection) times the correction over the focal length, which the residuals, as
// pixels do, grow with. The caller owns the result.
ceres::CostFunction* MakeUncalibratedCost(const Eigen::Vector2d& x_normalized, double sigma,
                                          const Eigen::Matrix<double, 2, 3>& by_correction);

// (correction - expected) / sigma of an intrinsics block, and its zeros. The caller owns the
// result.
ceres::CostFunction* MakeIntrinsicsCost(const Eigen::Vector3d& expected,
                                        const Eigen::Vector3d& sigma);

// rotation <- Exp(w) * rotation, translation <- translation + v. With fixed_component 0, 1 or 2
// that component of the translation stays (the scale gauge of an adjustment) and of v counts for
// nothing; with -1 none does. The caller owns the result.
ceres::Manifold* MakePoseManifold(int fixed_component);

}  // namespace rovio_sfm
