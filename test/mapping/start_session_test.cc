#include "rovio_sfm/mapping/start_session.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

std::deque<FrameEvent> Held(const SyntheticDrive& drive) {
  return {drive.events.begin(), drive.events.begin() + 8};
}

Session EmptySession(const SyntheticDrive& drive) {
  return Session({1}, drive.events[0].id.drive, drive.world.camera);
}

TEST(StartSession, MakesTheTrueMapOfTwoFrames) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  const auto held = Held(drive);
  Session session = EmptySession(drive);
  const auto pair = FindBootstrapPair(held, session, {}, 1);
  ASSERT_TRUE(pair);
  ASSERT_TRUE(StartSession(*pair, held, {}, &session));
  EXPECT_EQ(CheckInvariants(session), "");
  EXPECT_EQ(session.keyframes().size(), 2u);
  EXPECT_GT(session.landmarks().size(), 100u);
  EXPECT_LT(PoseDistance(session.keyframe(0).cam_from_session, {}), 1e-12);
  const double unit = OriginInA(drive.world.cams_from_map[7]).norm();
  for (const auto& [id, landmark] : session.landmarks()) {
    EXPECT_LT((unit * landmark.position - drive.world.points[id - 1]).norm(), 1e-3);
  }
}

TEST(StartSession, StaysNearTheTruthWithNoise) {
  SyntheticDriveOptions options;
  options.world.noise_px = 1.0;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  const auto held = Held(drive);
  Session session = EmptySession(drive);
  const auto pair = FindBootstrapPair(held, session, {}, 1);
  ASSERT_TRUE(pair);
  ASSERT_TRUE(StartSession(*pair, held, {}, &session));
  Rigid3 truth = drive.world.cams_from_map[7];
  truth.translation.normalize();
  Rigid3 found = session.keyframe(7).cam_from_session;
  found.translation.normalize();
  EXPECT_LT(PoseDistance(found, truth), 0.03);
}

TEST(StartSession, LeavesTheSessionEmptyWhereTheMotionIsWrong) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  Session session = EmptySession(drive);
  BootstrapPair pair;
  pair.second = 7;
  pair.second_from_first.translation = {0, 1, 0};
  EXPECT_FALSE(StartSession(pair, Held(drive), {}, &session));
  EXPECT_TRUE(session.keyframes().empty());
  EXPECT_TRUE(session.tracks().empty());
  EXPECT_TRUE(session.landmarks().empty());
}

}  // namespace
}  // namespace rovio_sfm
