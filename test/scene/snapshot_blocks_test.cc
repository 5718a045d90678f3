#include "rovio_sfm/scene/snapshot_blocks.h"

#include <gtest/gtest.h>

#include "rovio_sfm/scene/session.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld SmallWorld() {
  SyntheticOptions options;
  options.num_points = 40;
  options.num_cams = 3;
  return MakeSyntheticWorld(options);
}

// Two frames, one light frame in another block of frames, landmarks in two blocks.
Session TwoBlockSession() {
  Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
  Keyframe frame;
  frame.tracks = {1, kLandmarksPerBlock + 1};
  frame.points.assign(2, Eigen::Vector2d::Zero());
  frame.sigmas.assign(2, 0.001);
  frame.colors.resize(2);
  session.AddKeyframe(0, frame);
  session.AddKeyframe(kFramesPerBlock - 2, frame);
  session.AddLandmark(1, {0, 0, 4}, {}, {{0, 0}, {kFramesPerBlock - 2, 0}});
  session.AddLandmark(kLandmarksPerBlock + 1, {1, 0, 4}, {}, {{0, 1}, {kFramesPerBlock - 2, 1}});
  LightFrame light;
  light.reference = kFramesPerBlock - 2;
  session.AddLightFrame(kFramesPerBlock + 3, light);
  return session;
}

TEST(SnapshotBlocks, AreSharedWhereNothingChanged) {
  const Session session = TwoBlockSession();
  const SessionSnapshot first = session.Snapshot(), second = session.Snapshot();
  ASSERT_EQ(first.frames.size(), 2u);
  ASSERT_EQ(first.landmarks.size(), 2u);
  EXPECT_EQ(first.frames, second.frames);
  EXPECT_EQ(first.landmarks, second.landmarks);
}

TEST(SnapshotBlocks, OnlyTheBlockOfAMovedLandmarkIsNew) {
  Session session = TwoBlockSession();
  const SessionSnapshot before = session.Snapshot();
  session.SetPosition(1, {0, 0, 5});
  const SessionSnapshot after = session.Snapshot();
  EXPECT_EQ(before.frames, after.frames);
  EXPECT_NE(before.landmarks[0], after.landmarks[0]);
  EXPECT_EQ(before.landmarks[1], after.landmarks[1]);
  EXPECT_EQ(before.landmarks[0]->front().position.z(), 4.0);
  EXPECT_EQ(after.landmarks[0]->front().position.z(), 5.0);
}

TEST(SnapshotBlocks, ALightFrameOfAnotherBlockMovesWithItsReference) {
  Session session = TwoBlockSession();
  const SessionSnapshot before = session.Snapshot();
  Rigid3 moved;
  moved.translation = {0, 0, 1};
  session.SetPose(kFramesPerBlock - 2, moved);
  const SessionSnapshot after = session.Snapshot();
  EXPECT_EQ(before.frames[1]->front().cam_from_session.translation.z(), 0.0);
  EXPECT_EQ(after.frames[1]->front().cam_from_session.translation.z(), 1.0);
}

TEST(SnapshotBlocks, GoWithTheirLastContent) {
  Session session = TwoBlockSession();
  session.Snapshot();
  session.RemoveLandmark(kLandmarksPerBlock + 1);
  session.RemoveKeyframe(kFramesPerBlock - 2);
  const SessionSnapshot after = session.Snapshot();
  EXPECT_EQ(after.landmarks.size(), 0u);  // the other landmark is left with one view
  ASSERT_EQ(after.frames.size(), 1u);
  EXPECT_EQ(after.frames[0]->size(), 1u);
}

TEST(SnapshotBlocks, MeasureTheLandmarks) {
  const SyntheticWorld world = SmallWorld();
  Session session = MakeMappedSession(world);
  const auto& [id, landmark] = *session.landmarks().begin();
  const size_t num_views = landmark.observations.size();
  const Eigen::Vector3d a = OriginInA(world.cams_from_map[landmark.observations.front().frame]);
  const Eigen::Vector3d b = OriginInA(world.cams_from_map[landmark.observations.back().frame]);
  const Eigen::Vector3d ray_a = (landmark.position - a).normalized();
  const Eigen::Vector3d ray_b = (landmark.position - b).normalized();
  const LandmarkSnapshot exact = session.Snapshot().landmarks[0]->front();
  EXPECT_EQ(exact.id, id);
  EXPECT_EQ(exact.num_views, num_views);
  EXPECT_LT(exact.mean_error_px, 1e-9);
  EXPECT_NEAR(exact.max_parallax_rad, std::acos(ray_a.dot(ray_b)), 1e-9);
  // One per cent of the depth sideways: an error of about 0.01 on the plane z = 1 in every view.
  const double depth = (world.cams_from_map[0] * landmark.position).z();
  session.SetPosition(id, landmark.position + Eigen::Vector3d(0.0, 0.01 * depth, 0.0));
  const LandmarkSnapshot moved = session.Snapshot().landmarks[0]->front();
  EXPECT_NEAR(moved.mean_error_px, 0.01 * world.camera.MeanFocal(), 1.5);
  EXPECT_NEAR(moved.squared_error_normalized, 1e-4 * static_cast<double>(num_views), 0.5e-4);
}

TEST(SnapshotBlocks, KeepTheOrderOfKeyframesAndLightFrames) {
  Session session = MakeSyntheticSession(SmallWorld());
  LightFrame light;
  light.reference = 2;
  light.num_inliers = 33;
  session.AddLightFrame(3, light);
  session.SetWeak(1, true);
  const auto frames = session.Snapshot().frames;
  ASSERT_EQ(frames.size(), 1u);
  ASSERT_EQ(frames[0]->size(), 4u);
  for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ((*frames[0])[i].index, i);
  EXPECT_TRUE((*frames[0])[1].weak);
  EXPECT_EQ((*frames[0])[3].kind, FrameKind::kLight);
  EXPECT_EQ((*frames[0])[3].num_observations, 33u);
  EXPECT_LT(PoseDistance((*frames[0])[3].cam_from_session, session.keyframe(2).cam_from_session),
            1e-12);
}

}  // namespace
}  // namespace rovio_sfm
