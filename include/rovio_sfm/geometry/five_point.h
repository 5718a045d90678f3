#pragma once

#include <Eigen/Core>
#include <vector>

namespace rovio_sfm {

// All real essential matrices, singular values 1, 1, 0, that satisfy x_b^T E x_a = 0 for five
// matches of normalised points (Nistér 2004): at most 10; none if the matches are degenerate.
// The vectors hold exactly five points each.
std::vector<Eigen::Matrix3d> SolveFivePoint(const std::vector<Eigen::Vector2d>& points_a,
                                            const std::vector<Eigen::Vector2d>& points_b);

}  // namespace rovio_sfm
