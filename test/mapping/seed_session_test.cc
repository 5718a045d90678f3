#include "rovio_sfm/mapping/seed_session.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

struct Held {
  Held()
      : a(table.Adopt(MappedSession(two, false, OtherGauge()))),
        b(table.Open(two.b[0].id.drive, two.world.camera)) {
    held.assign(two.b.begin() + 5, two.b.begin() + 10);
  }

  TwoDrives two = MakeTwoDrives();
  SessionTable table;
  Session &a, &b;
  std::deque<FrameEvent> held;
};

TEST(SeedSession, PosesHeldFramesInTheMapTheySee) {
  Held setup;
  ASSERT_TRUE(SeedSession(setup.held, {TrueOverlap(setup.two, 7, 7)}, setup.table, MapperOptions(),
                          &setup.b));
  EXPECT_GE(setup.b.keyframes().size(), 3u);
  EXPECT_GT(setup.b.landmarks().size(), 50u);
  for (const auto& [index, frame] : setup.b.keyframes()) {
    const Rigid3 truth =
        TransformCamera(OtherGauge(), setup.two.world.cams_from_map[CameraOf(true, index)]);
    EXPECT_LT(PoseDistance(frame.cam_from_session, truth), 1e-5);
  }
  EXPECT_EQ(CheckInvariants(setup.b), "");
}

TEST(SeedSession, NeedsAMatchWithAMappedFrame) {
  Held setup;
  EXPECT_FALSE(SeedSession(setup.held, {}, setup.table, MapperOptions(), &setup.b));
  PlaceMatch unknown = TrueOverlap(setup.two, 7, 7);
  unknown.pairs[0].other.index = 99;
  EXPECT_FALSE(SeedSession(setup.held, {unknown}, setup.table, MapperOptions(), &setup.b));
  EXPECT_TRUE(setup.b.keyframes().empty());
}

TEST(SeedSession, LeavesNothingWhereMatchesAreFalse) {
  Held setup;
  PlaceMatch match = TrueOverlap(setup.two, 7, 7);
  Rng rng(4);
  for (FeatureMatch& inlier : match.pairs[0].inliers) {
    inlier.a = rng.UniformInt(static_cast<uint32_t>(setup.two.a[7].tracks.size()));
  }
  EXPECT_FALSE(SeedSession(setup.held, {match}, setup.table, MapperOptions(), &setup.b));
  EXPECT_TRUE(setup.b.keyframes().empty());
  EXPECT_TRUE(setup.b.landmarks().empty());
}

}  // namespace
}  // namespace rovio_sfm
