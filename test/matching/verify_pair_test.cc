#include "rovio_sfm/matching/verify_pair.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

struct Pair {
  SyntheticWorld world;
  std::vector<FeatureMatch> matches;
  Rigid3 b_from_a;
};

Pair MakePair(const SyntheticOptions& options, double outlier_share) {
  Pair pair;
  pair.world = MakeSyntheticWorld(options);
  Rng rng(17);
  pair.matches = MatchesWithOutliers(pair.world, 0, 1, outlier_share, rng);
  pair.b_from_a = pair.world.cams_from_map[1];
  return pair;
}

PairVerification Verify(const Pair& pair, const VerifyPairOptions& options = {}) {
  Rng rng(1);
  return VerifyPair(NormalizedPoints(pair.world, 0), NormalizedPoints(pair.world, 1), pair.matches,
                    pair.world.camera.MeanFocal(), options, rng);
}

double RotationError(const PairVerification& result, const Pair& pair) {
  return RotationAngle(result.cam_b_from_cam_a.rotation * pair.b_from_a.rotation.conjugate());
}

double DirectionError(const PairVerification& result, const Pair& pair) {
  return (result.cam_b_from_cam_a.translation - pair.b_from_a.translation.normalized()).norm();
}

size_t CountTrue(const PairVerification& result, const Pair& pair) {
  size_t count = 0;
  for (const uint32_t i : result.inliers) {
    count += IsTrueMatch(pair.world, 0, 1, pair.matches[i]) ? 1 : 0;
  }
  return count;
}

TEST(VerifyPair, IsExactWithoutNoiseBySidewaysAndForwardMotion) {
  for (const auto motion : {SyntheticMotion::kSideways, SyntheticMotion::kForward}) {
    SyntheticOptions world_options;
    world_options.motion = motion;
    world_options.step = 0.4;
    const Pair pair = MakePair(world_options, 0.0);
    const PairVerification result = Verify(pair);
    EXPECT_EQ(result.verdict, PairVerdict::kGeneral);
    EXPECT_EQ(result.inliers.size(), pair.matches.size());
    EXPECT_LT(RotationError(result, pair), 1e-6);
    EXPECT_LT(DirectionError(result, pair), 1e-5);
    EXPECT_GT(result.median_parallax_rad, 0.01);
  }
}

TEST(VerifyPair, FindsThePoseAmongNoiseAndHalfOutliers) {
  for (const auto method : {PairPoseMethod::kFivePoint, PairPoseMethod::kAlgebraic}) {
    SyntheticOptions world_options;
    world_options.noise_px = 0.5;
    world_options.step = 0.5;
    const Pair pair = MakePair(world_options, 0.5);
    VerifyPairOptions options;
    options.pose_method = method;
    const PairVerification result = Verify(pair, options);
    EXPECT_EQ(result.verdict, PairVerdict::kGeneral);
    EXPECT_LT(RotationError(result, pair), 0.01);
    EXPECT_LT(DirectionError(result, pair), 0.1);
    const size_t num_true = CountTrue(result, pair);
    EXPECT_GE(num_true, TrueMatches(pair.world, 0, 1).size() * 9 / 10);
    EXPECT_LE(result.inliers.size() - num_true, num_true / 20);
  }
}

TEST(VerifyPair, CallsATurnOnTheSpotARotation) {
  for (const double noise_px : {0.0, 0.5, 1.0}) {
    SyntheticOptions world_options;
    world_options.motion = SyntheticMotion::kRotation;
    world_options.turn_rad = 0.1;
    world_options.noise_px = noise_px;
    const Pair pair = MakePair(world_options, 0.4);
    const PairVerification result = Verify(pair);
    EXPECT_EQ(result.verdict, PairVerdict::kRotation) << noise_px;
    EXPECT_LT(RotationError(result, pair), 0.002);
    EXPECT_EQ(result.cam_b_from_cam_a.translation, Eigen::Vector3d::Zero());
    EXPECT_LE(result.inliers.size() - CountTrue(result, pair), 2u);
  }
}

TEST(VerifyPair, CallsAWallPlanar) {
  for (const double noise_px : {0.0, 0.5}) {
    SyntheticOptions world_options;
    world_options.scene = SyntheticScene::kPlane;
    world_options.step = 0.6;
    world_options.noise_px = noise_px;
    const PairVerification result = Verify(MakePair(world_options, 0.3));
    EXPECT_EQ(result.verdict, PairVerdict::kPlanar);
    EXPECT_GT(result.homography_share, 0.45);
  }
}

TEST(VerifyPair, RefusesPureOutliersAndTooFewMatches) {
  SyntheticOptions world_options;
  Pair pair = MakePair(world_options, 0.5);
  std::vector<FeatureMatch> wrong;
  for (const FeatureMatch& match : pair.matches) {
    if (!IsTrueMatch(pair.world, 0, 1, match)) wrong.push_back(match);
  }
  pair.matches = wrong;
  VerifyPairOptions options;
  options.min_inliers = 30;
  const PairVerification result = Verify(pair, options);
  EXPECT_EQ(result.verdict, PairVerdict::kFailed);
  EXPECT_TRUE(result.inliers.empty());
  pair.matches.resize(10);
  EXPECT_EQ(Verify(pair).verdict, PairVerdict::kFailed);
  pair.matches.clear();
  EXPECT_EQ(Verify(pair).verdict, PairVerdict::kFailed);
}

TEST(VerifyPair, SurvivesMatchesThatAreAllTheSame) {
  Pair pair = MakePair({}, 0.0);
  pair.matches.assign(100, pair.matches.front());
  const PairVerification result = Verify(pair);
  EXPECT_NE(result.verdict, PairVerdict::kGeneral);
}

TEST(VerifyPair, GivesTheSameBytesForTheSameSeed) {
  SyntheticOptions world_options;
  world_options.noise_px = 1.0;
  const Pair pair = MakePair(world_options, 0.5);
  const PairVerification a = Verify(pair), b = Verify(pair);
  EXPECT_EQ(a.inliers, b.inliers);
  EXPECT_EQ(a.cam_b_from_cam_a.translation, b.cam_b_from_cam_a.translation);
}

TEST(VerifyPairOptions, NamesTheBadField) {
  std::string error;
  VerifyPairOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.threshold_px = 0.0;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("threshold_px"), std::string::npos);
  options = {};
  options.min_inliers = 3;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("min_inliers"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
