#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// Homographies H map normalised points of camera a onto those of camera b: x_b ~ H x_a.

// The homography of least algebraic error through at least 4 matches (normalised DLT), with
// determinant 1. Nothing for fewer, unequal counts, or points in a degenerate position.
std::optional<Eigen::Matrix3d> EstimateHomography(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b);

// The homography through exactly four matches, with determinant 1; faster than EstimateHomography.
// Nothing if it cannot be solved for, as with three points on a line.
std::optional<Eigen::Matrix3d> SolveFourPoint(const std::vector<Eigen::Vector2d>& points_a,
                                              const std::vector<Eigen::Vector2d>& points_b);

// Levenberg-Marquardt on the transfer error into b; never worse than the start. Nothing as above.
std::optional<Eigen::Matrix3d> RefineHomography(const std::vector<Eigen::Vector2d>& points_a,
                                                const std::vector<Eigen::Vector2d>& points_b,
                                                const Eigen::Matrix3d& b_from_a, int max_steps = 5);

// The square of the transfer error into b on the plane z = 1, halved because both points are noisy,
// so that it compares with the Sampson error of an essential matrix. Infinite behind camera b.
double SquaredTransferError(const Eigen::Matrix3d& b_from_a, const Eigen::Vector2d& x_a,
                            const Eigen::Vector2d& x_b);

// The rotation nearest to a homography between cameras in one place. Nothing if it is singular.
std::optional<Eigen::Quaterniond> RotationFromHomography(const Eigen::Matrix3d& b_from_a);

}  // namespace rovio_sfm
