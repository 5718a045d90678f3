#include "rovio_sfm/sessions/find_common_landmarks.h"

#include <gtest/gtest.h>

#include "sessions/cross_matches.h"

namespace rovio_sfm {
namespace {

TEST(FindCrossMatches, TellsWhatEachSessionKnows) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = MakeCrossMatches(sessions, 1, 2);
  ASSERT_GT(matches.size(), 50u);
  for (const CrossMatch& match : matches) {
    EXPECT_EQ(match.a.track, match.b.track);
    EXPECT_EQ(match.a.observation.frame, 1u);
    EXPECT_EQ(match.b.observation.frame, 2u);
    ASSERT_TRUE(IsCommon(match));
    const Eigen::Vector3d x = match.a.cam_from_session * match.a.landmark->position;
    EXPECT_LT((x.hnormalized() - match.a.x_normalized).norm(), 1e-9);
    EXPECT_LT((sessions.b_from_a * match.a.landmark->position - match.b.landmark->position).norm(),
              1e-9);
  }
}

TEST(FindCrossMatches, LeavesOutLandmarksThatTheFeatureDoesNotObserve) {
  TwoSessions sessions = MakeTwoSessions({});
  const auto before = MakeCrossMatches(sessions, 1, 2);
  sessions.a.RemoveObservation(before[0].a.track, before[0].a.observation);
  sessions.b.RemoveLandmark(before[1].b.track);
  const auto after = MakeCrossMatches(sessions, 1, 2);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_FALSE(after[0].a.landmark);
  EXPECT_TRUE(after[0].b.landmark);
  EXPECT_TRUE(after[1].a.landmark);
  EXPECT_FALSE(after[1].b.landmark);
}

TEST(FindCrossMatches, KnowsTheDistanceOfNearPointsBest) {
  const TwoSessions sessions = MakeTwoSessions({});
  for (const CrossMatch& match : MakeCrossMatches(sessions, 1, 2)) {
    const double distance = (match.a.cam_from_session * match.a.landmark->position).norm();
    // The widest baseline is 0.4 to 0.8 map units; the sigma of a feature is a pixel.
    EXPECT_GT(match.a.landmark->sigma_log_distance, 1.4 * match.a.sigma * distance / 0.9);
    EXPECT_LT(match.a.landmark->sigma_log_distance, 1.5 * match.a.sigma * distance / 0.2);
  }
}

TEST(FindCrossMatches, RefusesWeakAndUnknownFramesAndFeatures) {
  TwoSessions sessions = MakeTwoSessions({});
  const FrameId a{sessions.a.drive(), 1}, b{sessions.b.drive(), 2};
  const std::vector<FeatureMatch> matches = {{0, 0}, {100000, 0}, {0, 100000}};
  EXPECT_EQ(FindCrossMatches(sessions.a, sessions.b, a, b, matches).size(), 1u);
  EXPECT_TRUE(FindCrossMatches(sessions.a, sessions.b, b, a, matches).empty());
  EXPECT_TRUE(FindCrossMatches(sessions.a, sessions.b, {a.drive, 99}, b, matches).empty());
  EXPECT_TRUE(FindCrossMatches(sessions.a, sessions.b, a, b, {}).empty());
  sessions.b.SetWeak(2, true);
  EXPECT_TRUE(FindCrossMatches(sessions.a, sessions.b, a, b, matches).empty());
}

}  // namespace
}  // namespace rovio_sfm
