#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// Essential matrices E here relate matched normalised points of cameras a and b by x_b^T E x_a = 0
// (Eq. A.4.25), E = [t]x R with b_from_a = (R, t). points_a[i] and points_b[i] are one match.

// E of a relative pose, with the translation brought to length 1; zero for a pure rotation.
Eigen::Matrix3d EssentialFromPose(const Rigid3& b_from_a);

// The square of the first-order distance of a match from the epipolar constraint (Sampson 1982), on
// the plane z = 1.
inline double SquaredSampsonError(const Eigen::Matrix3d& essential, const Eigen::Vector2d& x_a,
                                  const Eigen::Vector2d& x_b) {
  const Eigen::Vector3d line_b = essential * x_a.homogeneous();
  const double line_a_x = essential.col(0).head<2>().dot(x_b) + essential(2, 0);
  const double line_a_y = essential.col(1).head<2>().dot(x_b) + essential(2, 1);
  const double residual = line_b.head<2>().dot(x_b) + line_b.z();
  const double norm = line_b.head<2>().squaredNorm() + line_a_x * line_a_x + line_a_y * line_a_y;
  return norm > 0.0 ? residual * residual / norm : 0.0;
}

// The nearest matrix with singular values 1, 1, 0 (A.4.4).
Eigen::Matrix3d ProjectOnEssentialSpace(const Eigen::Matrix3d& matrix);

// The normalised 8-point algorithm (A.4.3; Hartley 1997), projected on the essential space. Nothing
// for fewer than 8 matches, unequal counts, or matches that do not determine E.
std::optional<Eigen::Matrix3d> EstimateEightPoint(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b);

// The 8-point estimate improved by algebraic minimisation (§3.5): Levenberg-Marquardt over the
// epipole e, E = M [e]x, E e = 0; then projected on the essential space. Nothing as above.
std::optional<Eigen::Matrix3d> EstimateAlgebraic(const std::vector<Eigen::Vector2d>& points_a,
                                                 const std::vector<Eigen::Vector2d>& points_b);

// The four poses b_from_a whose essential matrix is E up to scale (A.4.5), with translations of
// length 1.
std::array<Rigid3, 4> DecomposeEssential(const Eigen::Matrix3d& essential);

// True if a match, triangulated, lies in front of both cameras.
bool IsInFront(const Rigid3& b_from_a, const Eigen::Vector2d& x_a, const Eigen::Vector2d& x_b);

// The one of the four poses that has most matches in front of both cameras (cheirality, A.4.5).
// Nothing if no pose has more than half of them.
std::optional<Rigid3> PoseFromEssential(const Eigen::Matrix3d& essential,
                                        const std::vector<Eigen::Vector2d>& points_a,
                                        const std::vector<Eigen::Vector2d>& points_b);

}  // namespace rovio_sfm
