#include "rovio_sfm/sessions/cross_residual.h"

#include <gtest/gtest.h>

#include "sessions/cross_matches.h"

namespace rovio_sfm {
namespace {

constexpr double kFloor = 0.02;

TEST(ResidualOf, IsZeroUnderTheTruth) {
  const TwoSessions sessions = MakeTwoSessions({});
  for (const CrossMatch& match : MakeCrossMatches(sessions, 1, 2)) {
    const auto residual = ResidualOf(match, sessions.b_from_a, kFloor);
    ASSERT_TRUE(residual);
    EXPECT_LT(residual->SquaredMax(), 1e-12);
    EXPECT_EQ(residual->NumComponents(), 5);
  }
}

TEST(ResidualOf, ForgivesAnUncertainDistanceButNoDirection) {
  const TwoSessions sessions = MakeTwoSessions({});
  CrossMatch match = MakeCrossMatches(sessions, 1, 2)[0];
  match.a.landmark->sigma_log_distance = 0.2;
  match.b.landmark.reset();
  const Eigen::Vector3d center = OriginInA(match.a.cam_from_session);
  const Eigen::Vector3d truth = match.a.landmark->position;
  match.a.landmark->position = center + std::exp(0.2) * (truth - center);
  EXPECT_LT(ResidualOf(match, sessions.b_from_a, kFloor)->SquaredMax(), 1.5);
  match.a.landmark->position = truth + Eigen::Vector3d(0, 0.2, 0);  // the baseline is along x
  EXPECT_GT(ResidualOf(match, sessions.b_from_a, kFloor)->SquaredMax(), 100.0);
}

TEST(ResidualOf, ComparesTheDistancesOfCommonLandmarks) {
  const TwoSessions sessions = MakeTwoSessions({});
  const CrossMatch match = MakeCrossMatches(sessions, 1, 2)[0];
  // Scaled about the centre of b's camera: the projection in b stays.
  const Eigen::Vector3d center = OriginInA(match.b.cam_from_session);
  const Sim3 about_center{1.5, Eigen::Quaterniond::Identity(), -0.5 * center};
  const auto residual = ResidualOf(match, about_center * sessions.b_from_a, kFloor);
  ASSERT_TRUE(residual && residual->a_in_b && residual->log_depth);
  EXPECT_LT(residual->a_in_b->norm(), 1e-6);
  const double sigma = std::hypot(std::hypot(match.a.landmark->sigma_log_distance, kFloor),
                                  std::hypot(match.b.landmark->sigma_log_distance, kFloor));
  EXPECT_NEAR(*residual->log_depth, std::log(1.5) / sigma, 1e-9);
  EXPECT_NEAR(residual->SquaredSum(),
              residual->b_in_a->squaredNorm() + *residual->log_depth * *residual->log_depth, 1e-9);
}

TEST(ResidualOf, RefusesLandmarksBehindTheCameraAndNone) {
  const TwoSessions sessions = MakeTwoSessions({});
  CrossMatch match = MakeCrossMatches(sessions, 1, 2)[0];
  Sim3 turned = sessions.b_from_a;
  turned.rotation = turned.rotation * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY());
  EXPECT_FALSE(ResidualOf(match, turned, kFloor));
  match.a.landmark.reset();
  match.b.landmark.reset();
  EXPECT_FALSE(ResidualOf(match, sessions.b_from_a, kFloor));
}

}  // namespace
}  // namespace rovio_sfm
