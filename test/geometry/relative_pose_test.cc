#include "rovio_sfm/geometry/relative_pose.h"

#include <gtest/gtest.h>

#include "rovio_sfm/geometry/essential.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

struct Pair {
  std::vector<Eigen::Vector2d> points_a, points_b;
  Rigid3 b_from_a;  // translation of length 1
};

Pair MakePair(double noise_px, SyntheticMotion motion = SyntheticMotion::kSideways) {
  SyntheticOptions options;
  options.noise_px = noise_px;
  options.motion = motion;
  options.step = 0.5;
  const SyntheticWorld world = MakeSyntheticWorld(options);
  Pair pair;
  for (const FeatureMatch& match : TrueMatches(world, 0, 1)) {
    pair.points_a.push_back(world.views[0][match.a].x_normalized);
    pair.points_b.push_back(world.views[1][match.b].x_normalized);
  }
  pair.b_from_a = world.cams_from_map[1] * Inverse(world.cams_from_map[0]);
  if (motion != SyntheticMotion::kRotation) pair.b_from_a.translation.normalize();
  return pair;
}

Rigid3 Disturb(const Rigid3& pose) {
  Eigen::Matrix<double, 5, 1> step;
  step << 0.01, -0.02, 0.01, 0.1, -0.05;
  return ApplyPoseStep(pose, step);
}

double RotationError(const Rigid3& a, const Rigid3& b) {
  return RotationAngle(a.rotation * b.rotation.conjugate());
}

TEST(SampsonEvaluator, JacobianEqualsNumericDerivative) {
  const Pair pair = MakePair(1.0);
  const Rigid3 pose = Disturb(pair.b_from_a);
  for (size_t i = 0; i < 10; ++i) {
    const SampsonResidual residual =
        SampsonEvaluator(pose).Evaluate(pair.points_a[i], pair.points_b[i]);
    for (int k = 0; k < 5; ++k) {
      Eigen::Matrix<double, 5, 1> step = Eigen::Matrix<double, 5, 1>::Zero();
      step(k) = 1e-6;
      const double plus = SampsonEvaluator(ApplyPoseStep(pose, step))
                              .Evaluate(pair.points_a[i], pair.points_b[i])
                              .value;
      const double minus = SampsonEvaluator(ApplyPoseStep(pose, -step))
                               .Evaluate(pair.points_a[i], pair.points_b[i])
                               .value;
      EXPECT_NEAR(residual.jacobian(k), (plus - minus) / 2e-6, 1e-6);
    }
  }
}

TEST(SampsonEvaluator, AgreesWithSquaredSampsonError) {
  const Pair pair = MakePair(1.0);
  const double value =
      SampsonEvaluator(pair.b_from_a).Evaluate(pair.points_a[0], pair.points_b[0]).value;
  EXPECT_NEAR(
      value * value,
      SquaredSampsonError(EssentialFromPose(pair.b_from_a), pair.points_a[0], pair.points_b[0]),
      1e-15);
}

TEST(RefineRelativePose, FindsTheTruePoseWithoutNoise) {
  for (const auto motion : {SyntheticMotion::kSideways, SyntheticMotion::kForward}) {
    const Pair pair = MakePair(0.0, motion);
    const auto pose = RefineRelativePose(pair.points_a, pair.points_b, Disturb(pair.b_from_a), 20);
    ASSERT_TRUE(pose);
    EXPECT_LT(RotationError(*pose, pair.b_from_a), 1e-6);
    EXPECT_LT((pose->translation - pair.b_from_a.translation).norm(), 1e-5);
  }
}

TEST(RefineRelativePose, StaysNearWithNoise) {
  const Pair pair = MakePair(0.5);
  const auto pose = RefineRelativePose(pair.points_a, pair.points_b, Disturb(pair.b_from_a));
  ASSERT_TRUE(pose);
  EXPECT_LT(RotationError(*pose, pair.b_from_a), 0.003);
  EXPECT_LT((pose->translation - pair.b_from_a.translation).norm(), 0.03);
}

TEST(RefineRelativePose, BearsWrongMatchesWithARobustLoss) {
  Pair pair = MakePair(0.3);
  for (size_t i = 0; i < pair.points_b.size(); i += 10) pair.points_b[i].y() += 0.02;
  const auto plain = RefineRelativePose(pair.points_a, pair.points_b, pair.b_from_a, 20);
  const auto robust = RefineRelativePose(pair.points_a, pair.points_b, pair.b_from_a, 20, 1e-3);
  ASSERT_TRUE(plain && robust);
  EXPECT_LT(RotationError(*robust, pair.b_from_a), 0.002);
  EXPECT_LT(RotationError(*robust, pair.b_from_a), RotationError(*plain, pair.b_from_a));
}

TEST(RefineRelativePose, RefusesEmptyUnequalAndZeroTranslation) {
  const Pair pair = MakePair(0.0);
  EXPECT_FALSE(RefineRelativePose({}, {}, pair.b_from_a));
  EXPECT_FALSE(RefineRelativePose(pair.points_a, {}, pair.b_from_a));
  EXPECT_FALSE(RefineRelativePose(pair.points_a, pair.points_b, Rigid3()));
}

TEST(EstimateRotation, IsExactForCamerasInOnePlace) {
  const Pair pair = MakePair(0.0, SyntheticMotion::kRotation);
  const auto rotation = EstimateRotation(pair.points_a, pair.points_b);
  ASSERT_TRUE(rotation);
  EXPECT_LT(RotationAngle(*rotation * pair.b_from_a.rotation.conjugate()), 1e-7);
}

TEST(EstimateRotation, StaysNearWithNoise) {
  const Pair pair = MakePair(1.0, SyntheticMotion::kRotation);
  const auto rotation = EstimateRotation(pair.points_a, pair.points_b);
  ASSERT_TRUE(rotation);
  EXPECT_LT(RotationAngle(*rotation * pair.b_from_a.rotation.conjugate()), 1e-3);
}

TEST(EstimateRotation, RefusesEmptyAndUnequalMatches) {
  EXPECT_FALSE(EstimateRotation({}, {}));
  EXPECT_FALSE(EstimateRotation({{0, 0}, {0.1, 0}}, {{0, 0}}));
}

}  // namespace
}  // namespace rovio_sfm
