#include "rovio_sfm/geometry/normalize_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace rovio_sfm {
namespace {

TEST(FindPointNormalization, GivesMeanZeroAndMeanDistanceRootTwo) {
  const std::vector<Eigen::Vector2d> points = {{1, 2}, {3, -1}, {0.5, 0.7}, {10, 4}};
  const auto transform = FindPointNormalization(points);
  ASSERT_TRUE(transform);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double distance = 0.0;
  for (const Eigen::Vector2d& x : points) {
    const Eigen::Vector2d moved = (*transform * x.homogeneous()).hnormalized();
    mean += moved / 4.0;
    distance += moved.norm() / 4.0;
  }
  EXPECT_LT(mean.norm(), 1e-12);
  EXPECT_NEAR(distance, std::sqrt(2.0), 1e-12);
}

TEST(FindPointNormalization, RefusesNoneAndOnePoint) {
  EXPECT_FALSE(FindPointNormalization({}));
  EXPECT_FALSE(FindPointNormalization({{0.1, 0.2}, {0.1, 0.2}}));
}

}  // namespace
}  // namespace rovio_sfm
