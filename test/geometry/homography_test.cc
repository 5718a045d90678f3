#include "rovio_sfm/geometry/homography.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

struct Pair {
  std::vector<Eigen::Vector2d> points_a, points_b;
  Rigid3 b_from_a;
};

Pair MakePair(SyntheticScene scene, SyntheticMotion motion, double noise_px) {
  SyntheticOptions options;
  options.scene = scene;
  options.motion = motion;
  options.noise_px = noise_px;
  const SyntheticWorld world = MakeSyntheticWorld(options);
  Pair pair;
  for (const FeatureMatch& match : TrueMatches(world, 0, 1)) {
    pair.points_a.push_back(world.views[0][match.a].x_normalized);
    pair.points_b.push_back(world.views[1][match.b].x_normalized);
  }
  pair.b_from_a = world.cams_from_map[1];
  return pair;
}

double RmsTransfer(const Eigen::Matrix3d& homography, const Pair& pair) {
  double sum = 0.0;
  for (size_t i = 0; i < pair.points_a.size(); ++i) {
    sum += SquaredTransferError(homography, pair.points_a[i], pair.points_b[i]);
  }
  return std::sqrt(sum / static_cast<double>(pair.points_a.size()));
}

TEST(EstimateHomography, IsExactOnAPlaneAndForARotation) {
  for (const Pair& pair : {MakePair(SyntheticScene::kPlane, SyntheticMotion::kSideways, 0.0),
                           MakePair(SyntheticScene::kVolume, SyntheticMotion::kRotation, 0.0)}) {
    const auto homography = EstimateHomography(pair.points_a, pair.points_b);
    ASSERT_TRUE(homography);
    EXPECT_LT(RmsTransfer(*homography, pair), 1e-9);
    EXPECT_NEAR(homography->determinant(), 1.0, 1e-9);
  }
}

TEST(EstimateHomography, WorksOnFourMatches) {
  const Pair pair = MakePair(SyntheticScene::kPlane, SyntheticMotion::kForward, 0.0);
  const std::vector<Eigen::Vector2d> four_a(pair.points_a.begin(), pair.points_a.begin() + 4);
  const std::vector<Eigen::Vector2d> four_b(pair.points_b.begin(), pair.points_b.begin() + 4);
  const auto homography = EstimateHomography(four_a, four_b);
  ASSERT_TRUE(homography);
  EXPECT_LT(RmsTransfer(*homography, pair), 1e-6);
}

TEST(SolveFourPoint, AgreesWithTheLeastSquares) {
  const Pair pair = MakePair(SyntheticScene::kPlane, SyntheticMotion::kForward, 1.0);
  const std::vector<Eigen::Vector2d> four_a(pair.points_a.begin(), pair.points_a.begin() + 4);
  const std::vector<Eigen::Vector2d> four_b(pair.points_b.begin(), pair.points_b.begin() + 4);
  const auto solved = SolveFourPoint(four_a, four_b);
  ASSERT_TRUE(solved);
  EXPECT_LT((*solved - *EstimateHomography(four_a, four_b)).norm(), 1e-6);
}

TEST(SolveFourPoint, RefusesThreePointsOnALine) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 1}, {2, 2}, {0, 1}};
  EXPECT_FALSE(SolveFourPoint(points, {{0, 0}, {1, 1}, {2, 0}, {0, 1}}));
}

TEST(EstimateHomography, RefusesTooFewUnequalAndCollinearMatches) {
  EXPECT_FALSE(EstimateHomography({}, {}));
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}};
  EXPECT_FALSE(EstimateHomography(line, line));
  EXPECT_FALSE(EstimateHomography(line, {{0, 0}}));
}

TEST(RefineHomography, LowersTheTransferErrorToTheNoise) {
  const Pair pair = MakePair(SyntheticScene::kPlane, SyntheticMotion::kSideways, 1.0);
  const Eigen::Matrix3d start =
      *EstimateHomography(pair.points_a, pair.points_b) + 1e-3 * Eigen::Matrix3d::Ones();
  const auto refined = RefineHomography(pair.points_a, pair.points_b, start, 10);
  ASSERT_TRUE(refined);
  EXPECT_LT(RmsTransfer(*refined, pair), RmsTransfer(start, pair));
  EXPECT_NEAR(RmsTransfer(*refined, pair) * 620.0, std::sqrt(2.0), 0.1);
  EXPECT_FALSE(RefineHomography({}, {}, start));
}

TEST(SquaredTransferError, IsInfiniteBehindTheCamera) {
  EXPECT_TRUE(std::isinf(SquaredTransferError(-Eigen::Matrix3d::Identity(), {0, 0}, {0, 0})));
}

TEST(RotationFromHomography, IsExactForCamerasInOnePlace) {
  const Pair pair = MakePair(SyntheticScene::kVolume, SyntheticMotion::kRotation, 0.0);
  const auto rotation =
      RotationFromHomography(-2.0 * *EstimateHomography(pair.points_a, pair.points_b));
  ASSERT_TRUE(rotation);
  EXPECT_LT(RotationAngle(*rotation * pair.b_from_a.rotation.conjugate()), 1e-7);
  EXPECT_FALSE(RotationFromHomography(Eigen::Matrix3d::Zero()));
}

}  // namespace
}  // namespace rovio_sfm
