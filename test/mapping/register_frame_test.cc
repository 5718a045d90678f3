#include "rovio_sfm/mapping/register_frame.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

SyntheticDrive DriveWithNoise(double noise_px, int light_frames = 0) {
  SyntheticDriveOptions options;
  options.world.noise_px = noise_px;
  options.light_frames = light_frames;
  return MakeSyntheticDrive(options);
}

TEST(RegisterKeyframe, RecoversTheExactPose) {
  const SyntheticDrive drive = DriveWithNoise(0.0);
  const Session session = MappedDrive(drive, 6);
  const auto registration = RegisterKeyframe(drive.events[6], {}, session);
  ASSERT_TRUE(registration);
  EXPECT_LT(PoseDistance(registration->cam_from_session, drive.world.cams_from_map[6]), 1e-7);
  EXPECT_EQ(registration->num_inliers, registration->num_matches);
  EXPECT_GT(registration->num_matches, 100u);
}

TEST(RegisterKeyframe, StaysNearTheTruthWithNoise) {
  const SyntheticDrive drive = DriveWithNoise(1.0);
  const auto registration = RegisterKeyframe(drive.events[6], {}, MappedDrive(drive, 6));
  ASSERT_TRUE(registration);
  EXPECT_LT(PoseDistance(registration->cam_from_session, drive.world.cams_from_map[6]), 0.02);
}

TEST(RegisterKeyframe, TrustsLargeFeaturesLess) {
  SyntheticDrive drive = DriveWithNoise(0.0);
  const Session session = MappedDrive(drive, 6);
  auto features = std::make_shared<FrameFeatures>(*drive.events[6].features);
  for (size_t i = 0; i < features->keypoints.size(); ++i) {
    features->keypoints[i].size_px = 2.0f;
    if (i % 3 == 0) features->keypoints[i].x_normalized.x() += 0.003;  // 2 px: an inlier still
  }
  drive.events[6].features = features;
  const auto error = [&] {
    const auto registration = RegisterKeyframe(drive.events[6], {}, session);
    return registration ? PoseDistance(registration->cam_from_session, drive.world.cams_from_map[6])
                        : 1.0;
  };
  const double trusted = error();
  for (size_t i = 0; i < features->keypoints.size(); i += 3) {
    features->keypoints[i].size_px = 600.0f;  // ten times less certain
  }
  EXPECT_LT(error(), 0.5 * trusted);
}

TEST(RegisterKeyframe, RefusesTooFewMatches) {
  SyntheticDrive drive = DriveWithNoise(0.0);
  const Session session = MappedDrive(drive, 6);
  EXPECT_FALSE(RegisterKeyframe(drive.events[6], {}, PosedDrive(drive, 6)));
  auto& tracks = drive.events[6].tracks;
  size_t num_kept = 0;
  for (TrackId& track : tracks) {
    if (track != 0 && session.FindLandmark(track) != nullptr && ++num_kept > 19) track = 0;
  }
  EXPECT_FALSE(RegisterKeyframe(drive.events[6], {}, session));
}

TEST(RegisterAgain, PosesAKeyframeOfTheSession) {
  const SyntheticDrive drive = DriveWithNoise(0.0);
  Session session = MappedDrive(drive, 6);
  session.AddKeyframe(6, MakeKeyframe(drive.events[6], {}, {}));
  const auto registration = RegisterAgain(6, {}, session);
  ASSERT_TRUE(registration);
  EXPECT_LT(PoseDistance(registration->cam_from_session, drive.world.cams_from_map[6]), 1e-7);
}

// Light frame 5 of a drive with keyframes 0, 2, 4, …
void ExpectPosed(const std::optional<Rigid3>& prediction) {
  const SyntheticDrive drive = DriveWithNoise(0.0, 1);
  const Session session = MappedDrive(drive, 9);
  LightFrame frame = MakeLightFrame(drive.events[5]);
  ASSERT_TRUE(PoseLightFrame(5, prediction, {}, &frame, session));
  EXPECT_EQ(frame.reference, 4u);
  EXPECT_GE(frame.num_inliers, 20u);
  const Rigid3 pose = frame.cam_from_reference * session.keyframe(4).cam_from_session;
  EXPECT_LT(PoseDistance(pose, drive.world.cams_from_map[5]), 1e-7);
}

TEST(PoseLightFrame, RecoversTheExactPoseFromAPrediction) {
  ExpectPosed(DriveWithNoise(0.0).world.cams_from_map[4]);
}

TEST(PoseLightFrame, RecoversTheExactPoseWithoutAPredictionOrFromABadOne) {
  ExpectPosed(std::nullopt);
  ExpectPosed(Rigid3{Eigen::Quaterniond(0, 0, 1, 0), {1, 2, 3}});
}

TEST(PoseLightFrame, TakesNoWeakReference) {
  const SyntheticDrive drive = DriveWithNoise(0.0, 1);
  Session session = MappedDrive(drive, 9);
  session.SetWeak(4, true);
  LightFrame frame = MakeLightFrame(drive.events[5]);
  ASSERT_TRUE(PoseLightFrame(5, {}, {}, &frame, session));
  EXPECT_EQ(frame.reference, 2u);
}

TEST(PoseLightFrame, RefusesAndLeavesTheFrameWhereNothingAgrees) {
  const SyntheticDrive drive = DriveWithNoise(0.0, 1);
  LightFrame frame = MakeLightFrame(drive.events[5]);
  frame.num_inliers = 77;
  EXPECT_FALSE(PoseLightFrame(5, {}, {}, &frame, PosedDrive(drive, 9)));
  const Session empty({1}, drive.events[0].id.drive, drive.world.camera);
  EXPECT_FALSE(PoseLightFrame(5, {}, {}, &frame, empty));
  EXPECT_EQ(frame.num_inliers, 77u);
}

// The tracks of the first landmarks that it shows stay its own, those of the next show others.
LightFrame ShowingFew(const SyntheticDrive& drive, const Session& session, size_t num_right,
                      size_t num_wrong) {
  LightFrame frame = MakeLightFrame(drive.events[5]);
  size_t count = 0;
  for (size_t i = 0; i < frame.tracks.size(); ++i) {
    if (session.FindLandmark(frame.tracks[i]) == nullptr) continue;
    if (count >= num_right) frame.points[i].x() += count % 2 == 0 ? 0.3 : -0.2;
    if (++count > num_right + num_wrong) frame.tracks[i] = 0;
  }
  return frame;
}

TEST(PoseLightFrame, IsPosedByFewLandmarksIfHalfOfThemAgree) {
  const SyntheticDrive drive = DriveWithNoise(0.0, 1);
  const Session session = MappedDrive(drive, 9);
  LightFrame few = ShowingFew(drive, session, 8, 4);
  ASSERT_TRUE(PoseLightFrame(5, {}, {}, &few, session));
  EXPECT_EQ(few.num_inliers, 8u);
  EXPECT_LT(PoseDistance(few.cam_from_reference * session.keyframe(4).cam_from_session,
                         drive.world.cams_from_map[5]),
            1e-7);
  LightFrame too_few = ShowingFew(drive, session, 7, 0);
  EXPECT_FALSE(PoseLightFrame(5, {}, {}, &too_few, session));
  LightFrame outvoted = ShowingFew(drive, session, 8, 9);
  EXPECT_FALSE(PoseLightFrame(5, {}, {}, &outvoted, session));
}

TEST(RefineLightFrames, MovesThemToWhereTheLandmarksSay) {
  const SyntheticDrive drive = DriveWithNoise(0.0, 1);
  Session session = MappedDrive(drive, 9);
  LightFrame frame = MakeLightFrame(drive.events[5]);
  ASSERT_TRUE(PoseLightFrame(5, {}, {}, &frame, session));
  frame.cam_from_reference.translation += Eigen::Vector3d(0.01, 0.0, 0.0);
  frame.num_inliers = 1;
  session.AddLightFrame(5, frame);
  LightFrame blind = frame;
  blind.tracks.clear();
  blind.points.clear();
  session.AddLightFrame(7, blind);
  RefineLightFrames({}, &session);
  const Rigid3& reference = session.keyframe(4).cam_from_session;
  const Rigid3 pose = session.light_frames().at(5).cam_from_reference * reference;
  EXPECT_LT(PoseDistance(pose, drive.world.cams_from_map[5]), 1e-7);
  EXPECT_GE(session.light_frames().at(5).num_inliers, 20u);
  EXPECT_EQ(session.light_frames().at(7).cam_from_reference.translation,
            frame.cam_from_reference.translation);
}

}  // namespace
}  // namespace rovio_sfm
