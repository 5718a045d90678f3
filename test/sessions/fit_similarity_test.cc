#include "rovio_sfm/sessions/fit_similarity.h"

#include <gtest/gtest.h>

#include "sessions/cross_matches.h"

namespace rovio_sfm {
namespace {

const Eigen::Vector3d kMiddle(0.5, 0.0, 4.0);

// The matches that tell something.
std::vector<uint32_t> All(const std::vector<CrossMatch>& matches) {
  std::vector<uint32_t> all;
  for (uint32_t i = 0; i < matches.size(); ++i) {
    if (matches[i].a.landmark || matches[i].b.landmark) all.push_back(i);
  }
  return all;
}

TEST(FitSimilarity, RecoversTheExactSimilarity) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = MakeCrossMatches(sessions, 0, 3);
  const Sim3 off{
      1.1, Eigen::Quaterniond(Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ())), {0.2, -0.1, 0.1}};
  const auto fitted = FitSimilarity(matches, All(matches), off * sessions.b_from_a, {});
  ASSERT_TRUE(fitted);
  EXPECT_LT(SimilarityDistance(*fitted, sessions.b_from_a, kMiddle), 1e-6);
}

TEST(FitSimilarity, RefusesNoMatchesAndLandmarksBehind) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = MakeCrossMatches(sessions, 0, 3);
  EXPECT_FALSE(FitSimilarity(matches, {}, sessions.b_from_a, {}));
  Sim3 turned = sessions.b_from_a;
  turned.rotation = turned.rotation * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY());
  EXPECT_FALSE(FitSimilarity(matches, All(matches), turned, {}));
}

// The spread of the estimates over many noises is what the sigmas say.
TEST(MeasureUncertainty, PredictsTheSpreadOfTheScale) {
  double sum_squared_sigmas = 0.0;
  constexpr int kTrials = 30;
  for (uint64_t seed = 1; seed <= kTrials; ++seed) {
    TwoSessionsOptions options;
    options.world.seed = seed;
    options.world.noise_px = 1.0;
    options.sigma_log_distance = 0.03;
    const TwoSessions sessions = MakeTwoSessions(options);
    const auto matches = MakeCrossMatches(sessions, 0, 0);
    const FitSimilarityOptions squared{20, 0.0, 0.02, {}};
    const auto fitted = FitSimilarity(matches, All(matches), sessions.b_from_a, squared);
    ASSERT_TRUE(fitted);
    const auto uncertainty = MeasureUncertainty(matches, All(matches), *fitted, squared);
    ASSERT_TRUE(uncertainty);
    const double error = std::log(fitted->scale / sessions.b_from_a.scale);
    sum_squared_sigmas += std::pow(error / uncertainty->sigma_log_scale, 2);
  }
  const double rms = std::sqrt(sum_squared_sigmas / kTrials);
  EXPECT_GT(rms, 0.3);
  EXPECT_LT(rms, 2.0);
}

TEST(MeasureUncertainty, RefusesWhatLeavesTheScaleOpen) {
  const TwoSessions sessions = MakeTwoSessions({});
  auto matches = MakeCrossMatches(sessions, 0, 3);
  for (CrossMatch& match : matches) match.b.landmark.reset();  // one camera of b sees a's map
  EXPECT_FALSE(MeasureUncertainty(matches, All(matches), sessions.b_from_a, {}));
  EXPECT_FALSE(MeasureUncertainty(matches, {}, sessions.b_from_a, {}));
}

}  // namespace
}  // namespace rovio_sfm
