#include "synthetic/two_sessions.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(TwoSessions, AreOneWorldInTwoGauges) {
  const TwoSessions sessions = MakeTwoSessions({});
  EXPECT_EQ(CheckInvariants(sessions.a), "");
  EXPECT_EQ(CheckInvariants(sessions.b), "");
  EXPECT_NE(sessions.a.drive(), sessions.b.drive());
  EXPECT_EQ(sessions.a.keyframes().size(), 4u);
  size_t num_common = 0;
  for (const auto& [track, landmark] : sessions.a.landmarks()) {
    const Landmark* other = sessions.b.FindLandmark(track);
    if (other == nullptr) continue;
    ++num_common;
    EXPECT_LT((sessions.b_from_a * landmark.position - other->position).norm(), 1e-9);
  }
  EXPECT_GT(num_common, 100u);
}

TEST(TwoSessions, MatchViewsOfOnePoint) {
  const TwoSessions sessions = MakeTwoSessions({});
  Rng rng(1);
  const auto matches = CrossFeatureMatches(sessions, 1, 2, 0.0, rng);
  ASSERT_GT(matches.size(), 50u);
  for (const FeatureMatch& match : matches) {
    EXPECT_EQ(sessions.a.keyframe(1).tracks[match.a], sessions.b.keyframe(2).tracks[match.b]);
  }
}

TEST(TwoSessions, MoveLandmarksAlongTheirRays) {
  TwoSessionsOptions options;
  options.sigma_log_distance = 0.05;
  const TwoSessions sessions = MakeTwoSessions(options);
  for (const auto& [track, landmark] : sessions.a.landmarks()) {
    const Eigen::Vector3d& truth = sessions.world_a.points[track - 1];
    EXPECT_LT(landmark.position.normalized().cross(truth.normalized()).norm(), 1e-9);
  }
  EXPECT_GT((sessions.a.landmarks().begin()->second.position - sessions.world_a.points[0]).norm(),
            1e-4);
}

TEST(SimilarityDistance, IsZeroForOneAndGrowsWithScale) {
  const Sim3 one{2.0, Eigen::Quaterniond::Identity(), {1, 2, 3}};
  EXPECT_DOUBLE_EQ(SimilarityDistance(one, one, {1, 1, 1}), 0.0);
  EXPECT_GT(SimilarityDistance({4.0, one.rotation, one.translation}, one, {1, 1, 1}), 0.6);
}

}  // namespace
}  // namespace rovio_sfm
