#include "rovio_sfm/report/level_session.h"

#include <gtest/gtest.h>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

TEST(LevelSession, SessionsOfAMergedMapShareItsUnit) {
  auto snapshot = std::make_shared<MapSnapshot>(*SmallMaps(2));
  snapshot->sessions[1].map = {1};
  snapshot->sessions[1].map_from_session.scale = 2.0;
  const SessionSnapshot& merged = snapshot->sessions[1];
  EXPECT_NEAR(CameraInLevel(merged, *FindFrame(merged, 4))->translation.x(), 4.0, 1e-9);
  snapshot->sessions[1].scale = MapScale{3.0, 0.01, "odometry"};  // shared: of its own unit
  EXPECT_NEAR(CameraInLevel(merged, *FindFrame(merged, 4))->translation.x(), 6.0, 1e-9);
}

TEST(LevelSession, RootIsTheFirstSessionWithAFrame) {
  auto snapshot = std::make_shared<MapSnapshot>(*SmallMaps(2));
  snapshot->sessions[0].frames.clear();
  ASSERT_NE(FindRoot(*snapshot), nullptr);
  EXPECT_EQ(FindRoot(*snapshot)->id.value, 2u);
  EXPECT_EQ(FindRoot(MapSnapshot()), nullptr);
}

TEST(LevelSession, FrameIsFoundByItsIndexAlone) {
  const SessionSnapshot session = SmallSession(1);
  ASSERT_NE(FindFrame(session, 2), nullptr);
  EXPECT_EQ(FindFrame(session, 2)->index, 2u);
  EXPECT_EQ(FindFrame(session, 3), nullptr);
  EXPECT_EQ(FindFrame(session, 9), nullptr);
}

}  // namespace
}  // namespace rovio_sfm
