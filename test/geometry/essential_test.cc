#include "rovio_sfm/geometry/essential.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

// The matched points of the first two cameras and their true relative pose.
struct Pair {
  std::vector<Eigen::Vector2d> points_a, points_b;
  Rigid3 b_from_a;
};

Pair MakePair(const SyntheticOptions& options) {
  const SyntheticWorld world = MakeSyntheticWorld(options);
  Pair pair;
  for (const FeatureMatch& match : TrueMatches(world, 0, 1)) {
    pair.points_a.push_back(world.views[0][match.a].x_normalized);
    pair.points_b.push_back(world.views[1][match.b].x_normalized);
  }
  pair.b_from_a = world.cams_from_map[1] * Inverse(world.cams_from_map[0]);
  return pair;
}

Pair MakePair(double noise_px, SyntheticScene scene = SyntheticScene::kVolume) {
  SyntheticOptions options;
  options.noise_px = noise_px;
  options.scene = scene;
  options.step = 0.5;
  return MakePair(options);
}

double Distance(const Eigen::Matrix3d& essential, const Rigid3& b_from_a) {
  const Eigen::Matrix3d truth = EssentialFromPose(b_from_a);
  return std::min((essential - truth).norm(), (essential + truth).norm());
}

TEST(EssentialFromPose, RelatesMatchedPoints) {
  const Pair pair = MakePair(0.0);
  const Eigen::Matrix3d essential = EssentialFromPose(pair.b_from_a);
  EXPECT_NEAR(essential.squaredNorm(), 2.0, 1e-12);
  for (size_t i = 0; i < pair.points_a.size(); ++i) {
    EXPECT_LT(SquaredSampsonError(essential, pair.points_a[i], pair.points_b[i]), 1e-24);
  }
}

TEST(SquaredSampsonError, IsNearTheSquaredDistanceForASmallShift) {
  const Rigid3 sideways{Eigen::Quaterniond::Identity(), {1, 0, 0}};
  const Eigen::Matrix3d essential = EssentialFromPose(sideways);
  // Epipolar lines are horizontal; a shift of d in one image lies d / sqrt(2) from the manifold.
  EXPECT_NEAR(SquaredSampsonError(essential, {0.1, 0.2}, {0.3, 0.202}), 2e-6, 1e-12);
}

TEST(ProjectOnEssentialSpace, MakesSingularValuesOneOneZero) {
  Eigen::Matrix3d matrix;
  matrix << 1, 2, 3, -1, 0.5, 2, 0.3, -2, 1;
  const Eigen::Vector3d values = ProjectOnEssentialSpace(matrix).jacobiSvd().singularValues();
  EXPECT_LT((values - Eigen::Vector3d(1, 1, 0)).norm(), 1e-12);
}

TEST(EstimateEightPoint, IsExactWithoutNoise) {
  const Pair pair = MakePair(0.0);
  const auto essential = EstimateEightPoint(pair.points_a, pair.points_b);
  ASSERT_TRUE(essential);
  EXPECT_LT(Distance(*essential, pair.b_from_a), 1e-6);
}

TEST(EstimateAlgebraic, IsExactWithoutNoise) {
  const Pair pair = MakePair(0.0);
  const auto essential = EstimateAlgebraic(pair.points_a, pair.points_b);
  ASSERT_TRUE(essential);
  EXPECT_LT(Distance(*essential, pair.b_from_a), 1e-6);
}

TEST(EstimateAlgebraic, StaysNearWithNoise) {
  const Pair pair = MakePair(0.5);
  const auto essential = EstimateAlgebraic(pair.points_a, pair.points_b);
  ASSERT_TRUE(essential);
  EXPECT_LT(Distance(*essential, pair.b_from_a), 0.1);
}

TEST(EstimateAlgebraic, IsOnAverageNoWorseThanEightPoint) {
  double sum_eight = 0.0, sum_algebraic = 0.0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SyntheticOptions options;
    options.seed = seed;
    options.noise_px = 1.0;
    const Pair pair = MakePair(options);
    sum_eight += Distance(*EstimateEightPoint(pair.points_a, pair.points_b), pair.b_from_a);
    sum_algebraic += Distance(*EstimateAlgebraic(pair.points_a, pair.points_b), pair.b_from_a);
  }
  EXPECT_LE(sum_algebraic, 1.02 * sum_eight);
}

TEST(EstimateEightPoint, RefusesTooFewUnequalAndDegenerateMatches) {
  const Pair pair = MakePair(0.0);
  EXPECT_FALSE(EstimateEightPoint({}, {}));
  EXPECT_FALSE(EstimateEightPoint(pair.points_a, {}));
  const std::vector<Eigen::Vector2d> seven(pair.points_a.begin(), pair.points_a.begin() + 7);
  EXPECT_FALSE(EstimateAlgebraic(seven, seven));
  const std::vector<Eigen::Vector2d> same(20, Eigen::Vector2d(0.1, 0.1));
  EXPECT_FALSE(EstimateAlgebraic(same, same));
  const Pair planar = MakePair(0.0, SyntheticScene::kPlane);
  EXPECT_FALSE(EstimateEightPoint(planar.points_a, planar.points_b));
}

TEST(DecomposeEssential, ContainsTheTruePoseAndOnlyPosesOfThisMatrix) {
  const Pair pair = MakePair(0.0);
  const Eigen::Matrix3d essential = EssentialFromPose(pair.b_from_a);
  double nearest = 10.0;
  for (const Rigid3& pose : DecomposeEssential(essential)) {
    EXPECT_LT(Distance(essential, pose), 1e-9);
    nearest =
        std::min(nearest, RotationAngle(pose.rotation * pair.b_from_a.rotation.conjugate()) +
                              (pose.translation - pair.b_from_a.translation.normalized()).norm());
  }
  EXPECT_LT(nearest, 1e-9);
}

TEST(PoseFromEssential, ChoosesThePoseInFrontOfBothCameras) {
  for (const auto motion : {SyntheticMotion::kSideways, SyntheticMotion::kForward}) {
    SyntheticOptions options;
    options.motion = motion;
    const Pair pair = MakePair(options);
    const Eigen::Matrix3d essential = -EssentialFromPose(pair.b_from_a);
    const auto pose = PoseFromEssential(essential, pair.points_a, pair.points_b);
    ASSERT_TRUE(pose);
    EXPECT_LT(RotationAngle(pose->rotation * pair.b_from_a.rotation.conjugate()), 1e-7);
    EXPECT_LT((pose->translation - pair.b_from_a.translation.normalized()).norm(), 1e-9);
  }
}

TEST(PoseFromEssential, RefusesEmptyAndUndecidedMatches) {
  const Pair pair = MakePair(0.0);
  const Eigen::Matrix3d essential = EssentialFromPose(pair.b_from_a);
  EXPECT_FALSE(PoseFromEssential(essential, {}, {}));
  EXPECT_FALSE(PoseFromEssential(essential, pair.points_a, {}));
}

TEST(IsInFront, SeesPointsBehindACamera) {
  const Rigid3 forward{Eigen::Quaterniond::Identity(), {0, 0, -1}};  // b is 1 ahead of a
  const Eigen::Vector3d ahead(0.2, 0.1, 3.0), between(0.2, 0.1, 0.5);
  EXPECT_TRUE(IsInFront(forward, ahead.hnormalized(), (forward * ahead).hnormalized()));
  EXPECT_FALSE(IsInFront(forward, between.hnormalized(), (forward * between).hnormalized()));
}

}  // namespace
}  // namespace rovio_sfm
