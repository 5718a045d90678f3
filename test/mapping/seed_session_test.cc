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

// A third drive through the same places, with a gauge of its own.
Session OtherSession(const TwoDrives& two) {
  const Session a = MappedSession(two, false, {});
  Session third({3}, {"third", 3, 1}, two.world.camera);
  for (const auto& [index, keyframe] : a.keyframes()) {
    Keyframe frame = keyframe;
    frame.observed.assign(frame.observed.size(), 0);
    frame.num_observed = 0;
    third.AddKeyframe(index, frame);
  }
  for (const auto& [id, landmark] : a.landmarks()) {
    third.AddLandmark(id, landmark.position, {}, landmark.observations);
  }
  return third;
}

TEST(SeedSession, TakesTheSessionThatTheMatchesShowMostOf) {
  Held setup;
  const Session& third = setup.table.Adopt(OtherSession(setup.two));
  PlaceMatch match = TrueOverlap(setup.two, 7, 7);  // in the first drive and in the third
  match.pairs.push_back(match.pairs[0]);
  match.pairs[1].other.drive = third.drive();
  match.pairs[1].inliers.resize(match.pairs[0].inliers.size() / 3);
  ASSERT_TRUE(SeedSession(setup.held, {match}, setup.table, MapperOptions(), &setup.b));
  for (const auto& [index, frame] : setup.b.keyframes()) {
    const Rigid3 truth =
        TransformCamera(OtherGauge(), setup.two.world.cams_from_map[CameraOf(true, index)]);
    EXPECT_LT(PoseDistance(frame.cam_from_session, truth), 1e-5);
  }
}

TEST(SeedSession, BorrowsNoLandmarkByAFrameOfAnotherDrive) {
  Held setup;
  PlaceMatch match = TrueOverlap(setup.two, 7, 7);
  OverlapPair foreign = match.pairs[0];  // the same index in a drive that nobody holds
  foreign.other.drive.robot = "nobody";
  std::reverse(foreign.inliers.begin(), foreign.inliers.end());
  for (size_t i = 0; i < foreign.inliers.size(); ++i) {
    foreign.inliers[i].b = match.pairs[0].inliers[i].b;
  }
  match.pairs.insert(match.pairs.begin(), foreign);
  ASSERT_TRUE(SeedSession(setup.held, {match}, setup.table, MapperOptions(), &setup.b));
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
