#include "rovio_sfm/geometry/pair_estimators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/geometry/ransac.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

constexpr double kFocal = 620.0;

struct Pair {
  SyntheticWorld world;
  std::vector<FeatureMatch> matches;
  PointPairs points;
};

Pair MakePair(SyntheticScene scene, double noise_px, double outlier_share) {
  SyntheticOptions options;
  options.scene = scene;
  options.noise_px = noise_px;
  Pair pair;
  pair.world = MakeSyntheticWorld(options);
  Rng rng(3);
  pair.matches = MatchesWithOutliers(pair.world, 0, 1, outlier_share, rng);
  for (const FeatureMatch& match : pair.matches) {
    pair.points.a.push_back(pair.world.views[0][match.a].x_normalized);
    pair.points.b.push_back(pair.world.views[1][match.b].x_normalized);
  }
  return pair;
}

RansacOptions MakeOptions(double threshold_px) {
  RansacOptions options;
  options.threshold = threshold_px / kFocal;
  return options;
}

TEST(EssentialEstimator, FindsTheTrueMatchesAmongHalfOutliers) {
  const Pair pair = MakePair(SyntheticScene::kVolume, 0.3, 0.5);
  Rng rng(1);
  const auto report = Ransac(EssentialEstimator(pair.points), MakeOptions(1.5), rng);
  ASSERT_TRUE(report);
  size_t num_true = 0;
  for (const uint32_t i : report->inliers) {
    num_true += IsTrueMatch(pair.world, 0, 1, pair.matches[i]) ? 1 : 0;
  }
  EXPECT_GE(num_true, TrueMatches(pair.world, 0, 1).size() * 98 / 100);
  EXPECT_LE(report->inliers.size() - num_true, num_true / 20);
}

TEST(EssentialEstimator, TruncatedLossIsTheSumOverTheResiduals) {
  const Pair pair = MakePair(SyntheticScene::kVolume, 0.5, 0.5);
  const EssentialEstimator estimator(pair.points);
  const Eigen::Matrix3d essential = EssentialFromPose(pair.world.cams_from_map[1]);
  const double squared_threshold = std::pow(1.5 / kFocal, 2);
  double expected = 0.0;
  for (uint32_t i = 0; i < estimator.NumData(); ++i) {
    expected += std::min(estimator.SquaredResidual(essential, i) / squared_threshold, 1.0);
  }
  EXPECT_NEAR(estimator.TruncatedLoss(essential, squared_threshold, 1e9), expected, 0.1);
  EXPECT_GT(estimator.TruncatedLoss(essential, squared_threshold, 10.0), 10.0);
}

TEST(HomographyEstimator, FindsThePlaneAmongHalfOutliers) {
  const Pair pair = MakePair(SyntheticScene::kPlane, 0.3, 0.5);
  Rng rng(1);
  const auto report = Ransac(HomographyEstimator(pair.points), MakeOptions(1.5), rng);
  ASSERT_TRUE(report);
  for (const uint32_t i : report->inliers) {
    EXPECT_TRUE(IsTrueMatch(pair.world, 0, 1, pair.matches[i]));
  }
  EXPECT_GE(report->inliers.size(), TrueMatches(pair.world, 0, 1).size() * 95 / 100);
}

TEST(PairEstimators, RefuseEmptyData) {
  Rng rng(1);
  const PointPairs none;
  EXPECT_FALSE(Ransac(EssentialEstimator(none), MakeOptions(1.5), rng));
  EXPECT_FALSE(Ransac(HomographyEstimator(none), MakeOptions(1.5), rng));
  EXPECT_FALSE(EssentialEstimator(none).Refine(Eigen::Matrix3d::Identity(), {}));
  EXPECT_FALSE(HomographyEstimator(none).Refine(Eigen::Matrix3d::Identity(), {}));
}

}  // namespace
}  // namespace rovio_sfm
