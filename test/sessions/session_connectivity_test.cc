#include "rovio_sfm/sessions/session_connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// world_from_session for every session but 1, whose gauge is the world.
Sim3 TruthOf(SessionId session) {
  if (session.value == 1) return {};
  Rng rng(session.value);
  const Eigen::Quaterniond rotation(rng.Gaussian(), rng.Gaussian(), rng.Gaussian(), rng.Gaussian());
  return {rng.Uniform(0.5, 2.0),
          rotation.normalized(),
          {rng.Gaussian(), rng.Gaussian(), rng.Gaussian()}};
}

SessionLink TrueLink(uint32_t a, uint32_t b, double weight = 1.0) {
  return {{a}, {b}, Inverse(TruthOf({b})) * TruthOf({a}), weight};
}

double Distance(const Sim3& b_from_a, const Sim3& other) {
  return RotationAngle(b_from_a.rotation * other.rotation.conjugate()) +
         std::abs(b_from_a.scale - other.scale) + (b_from_a.translation - other.translation).norm();
}

const std::vector<SessionId> kFive = {{1}, {2}, {3}, {4}, {5}};

TEST(ConnectSessions, LeavesSessionsApartWithoutLinks) {
  const auto maps = ConnectSessions(kFive, {});
  ASSERT_EQ(maps.size(), 5u);
  for (uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(maps[i].id, MapId{i + 1});
    ASSERT_EQ(maps[i].members.size(), 1u);
    EXPECT_EQ(Distance(maps[i].members[0].map_from_session, {}), 0.0);
  }
  EXPECT_TRUE(ConnectSessions({}, {}).empty());
}

TEST(ConnectSessions, PlacesEverySessionInTheGaugeOfTheSmallest) {
  const auto maps = ConnectSessions(kFive, {TrueLink(4, 2), TrueLink(1, 4), TrueLink(5, 3)});
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(maps[0].id, MapId{1});
  ASSERT_EQ(maps[0].members.size(), 3u);
  for (const MapMember& member : maps[0].members) {
    EXPECT_LT(Distance(member.map_from_session, TruthOf(member.session)), 1e-12);
  }
  EXPECT_EQ(maps[1].id, MapId{3});
  ASSERT_EQ(maps[1].members.size(), 2u);
  EXPECT_EQ(maps[1].members[1].session, SessionId{5});
  EXPECT_LT(Distance(maps[1].members[1].map_from_session, Inverse(TruthOf({3})) * TruthOf({5})),
            1e-12);
}

TEST(ConnectSessions, GivesTheSameMapsInAnyOrder) {
  std::vector<SessionLink> links = {TrueLink(1, 2), TrueLink(2, 3), TrueLink(3, 1),
                                    TrueLink(4, 2), TrueLink(1, 2), TrueLink(5, 4)};
  links[4].b_from_a.scale *= 1.01;
  const auto expected = ConnectSessions(kFive, links);
  Rng rng(3);
  for (int trial = 0; trial < 20; ++trial) {
    for (size_t i = links.size(); i > 1; --i) {
      std::swap(links[i - 1], links[rng.UniformInt(static_cast<uint32_t>(i))]);
    }
    const auto maps = ConnectSessions(kFive, links);
    ASSERT_EQ(maps.size(), expected.size());
    for (size_t i = 0; i < maps[0].members.size(); ++i) {
      EXPECT_EQ(
          Distance(maps[0].members[i].map_from_session, expected[0].members[i].map_from_session),
          0.0);
    }
    EXPECT_EQ(maps[0].gaps.size(), 2u);
  }
}

TEST(ConnectSessions, PrefersHeavyLinksAndReportsTheContradiction) {
  SessionLink wrong = TrueLink(3, 1, 0.5);
  wrong.b_from_a.scale *= 1.2;
  const auto maps = ConnectSessions(kFive, {wrong, TrueLink(1, 2, 2.0), TrueLink(2, 3, 3.0)});
  EXPECT_LT(Distance(maps[0].members[2].map_from_session, TruthOf({3})), 1e-12);
  ASSERT_EQ(maps[0].gaps.size(), 1u);
  EXPECT_EQ(maps[0].gaps[0].link, 0u);
  EXPECT_NEAR(maps[0].gaps[0].log_scale, std::log(1.2), 1e-12);
  EXPECT_NEAR(maps[0].gaps[0].rotation_rad, 0.0, 1e-7);
  EXPECT_GT(maps[0].gaps[0].distance, 0.0);
}

TEST(ConnectSessions, ReportsNoGapWhereCyclesAgree) {
  const auto maps = ConnectSessions(kFive, {TrueLink(1, 2), TrueLink(3, 2), TrueLink(3, 1)});
  ASSERT_EQ(maps[0].gaps.size(), 1u);
  EXPECT_NEAR(maps[0].gaps[0].log_scale, 0.0, 1e-12);
  EXPECT_LT(maps[0].gaps[0].distance, 1e-12);
}

TEST(ConnectSessions, TakesALoopOfOneSessionAsACycle) {
  const SessionLink loop{{2}, {2}, {1.1, Eigen::Quaterniond::Identity(), {0.5, 0, 0}}, 1.0};
  const auto maps = ConnectSessions(kFive, {loop});
  EXPECT_EQ(maps.size(), 5u);
  ASSERT_EQ(maps[1].gaps.size(), 1u);
  EXPECT_NEAR(maps[1].gaps[0].log_scale, std::log(1.1), 1e-12);
  EXPECT_NEAR(maps[1].gaps[0].distance, 0.5, 1e-12);
}

TEST(ConnectSessions, UndoesAMergeByLeavingItsLinkOut) {
  const std::vector<SessionLink> both = {TrueLink(1, 2), TrueLink(2, 3)};
  EXPECT_EQ(ConnectSessions(kFive, both).size(), 3u);
  const auto maps = ConnectSessions(kFive, {both[1]});
  ASSERT_EQ(maps.size(), 4u);
  EXPECT_EQ(maps[1].id, MapId{2});
  EXPECT_EQ(maps[1].members.size(), 2u);
}

}  // namespace
}  // namespace rovio_sfm
