#include "rovio_sfm/merging/share_scales.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

SessionSnapshot Member(uint32_t id, uint32_t map, double map_from_session,
                       std::optional<MapScale> scale) {
  SessionSnapshot session;
  session.id = {id};
  session.map = {map};
  session.map_from_session.scale = map_from_session;
  session.scale = scale;
  return session;
}

TEST(ShareScales, MeansLogarithmsByInverseVariance) {
  std::vector<SessionSnapshot> sessions = {Member(1, 1, 1.0, MapScale{2.0, 0.1, "odometry"}),
                                           Member(2, 1, 0.5, MapScale{1.21, 0.1, "odometry"})};
  ShareScales(&sessions);  // 2 and 2.42 m per map unit
  EXPECT_NEAR(sessions[0].scale->metres_per_unit, std::sqrt(2.0 * 2.42), 1e-12);
  EXPECT_NEAR(sessions[1].scale->metres_per_unit, 0.5 * std::sqrt(2.0 * 2.42), 1e-12);
  EXPECT_NEAR(sessions[0].scale->sigma_log, 0.1 / std::sqrt(2.0), 1e-12);
}

TEST(ShareScales, NamesEverySourceOnce) {
  std::vector<SessionSnapshot> sessions = {Member(1, 1, 1.0, MapScale{2.0, 0.1, "odometry"}),
                                           Member(2, 1, 1.0, MapScale{2.0, 0.1, "camera height"}),
                                           Member(3, 1, 1.0, MapScale{2.0, 0.1, "odometry"})};
  ShareScales(&sessions);
  for (const SessionSnapshot& session : sessions) {
    EXPECT_EQ(session.scale->source, "camera height, odometry");
  }
}

TEST(ShareScales, GivesAScaleToSessionsWithoutOne) {
  std::vector<SessionSnapshot> sessions = {Member(1, 1, 1.0, std::nullopt),
                                           Member(2, 1, 2.0, MapScale{3.0, 0.1, "odometry"}),
                                           Member(3, 3, 1.0, std::nullopt)};
  ShareScales(&sessions);
  EXPECT_NEAR(sessions[0].scale->metres_per_unit, 1.5, 1e-12);
  EXPECT_FALSE(sessions[2].scale);
}

TEST(ShareScales, LeavesASessionAloneWithItsOwn) {
  std::vector<SessionSnapshot> sessions = {Member(1, 1, 1.0, MapScale{2.0, 0.1, "odometry"})};
  ShareScales(&sessions);
  EXPECT_EQ(sessions[0].scale->metres_per_unit, 2.0);
}

TEST(ScaleDisagreement, CountsSigmas) {
  const MapScale a{2.0, 0.03, "odometry"}, b{1.0, 0.04, "odometry"};
  EXPECT_NEAR(
      ScaleDisagreement(a, b, {2.0, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()}), 0.0,
      1e-9);
  EXPECT_NEAR(
      ScaleDisagreement(
          a, b, {2.0 * std::exp(0.1), Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()}),
      2.0, 1e-9);
  EXPECT_EQ(ScaleDisagreement(a, std::nullopt, {}), 0.0);
}

}  // namespace
}  // namespace rovio_sfm
