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

TEST(NormalizeMatches, MovesEitherListByItsOwnTransform) {
  const std::vector<Eigen::Vector2d> points_a = {{1, 2}, {3, -1}}, points_b = {{5, 5}, {0.5, 0.7}};
  const auto matches = NormalizeMatches(points_a, points_b, 2);
  ASSERT_TRUE(matches);
  EXPECT_EQ(matches->x_a[1], matches->transform_a * points_a[1].homogeneous());
  EXPECT_EQ(matches->x_b[1], matches->transform_b * points_b[1].homogeneous());
  EXPECT_LT((matches->x_b[0] + matches->x_b[1]).head<2>().norm(), 1e-12);
}

TEST(NormalizeMatches, RefusesTooFewUnequalListsAndOnePoint) {
  const std::vector<Eigen::Vector2d> two = {{1, 2}, {3, -1}}, one = {{1, 2}},
                                     same = {{1, 2}, {1, 2}};
  EXPECT_FALSE(NormalizeMatches(two, two, 3));
  EXPECT_FALSE(NormalizeMatches(two, one, 1));
  EXPECT_FALSE(NormalizeMatches(two, same, 2));
}

}  // namespace
}  // namespace rovio_sfm
