#include "rovio_sfm/mapping/make_keyframe.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_drive.h"

namespace rovio_sfm {
namespace {

TEST(FeatureSigma, IsThePixelsForSmallFeaturesAndGrowsWithLargeOnes) {
  const Camera camera = MakeSyntheticCamera();
  MapperOptions options;
  options.pixel_sigma_px = 2.0;
  Keypoint keypoint;
  keypoint.size_px = 2.0f;
  EXPECT_NEAR(FeatureSigma(keypoint, camera, options), 2.0 / camera.MeanFocal(), 1e-12);
  keypoint.size_px = 24.0f;  // four times sigma_size_px
  EXPECT_NEAR(FeatureSigma(keypoint, camera, options), 4.0 / camera.MeanFocal(), 1e-12);
  options.sigma_exponent = 0.0;
  EXPECT_NEAR(FeatureSigma(keypoint, camera, options), 2.0 / camera.MeanFocal(), 1e-12);
}

TEST(MakeKeyframe, TakesEverythingFromTheEvent) {
  SyntheticDriveOptions drive_options;
  drive_options.metres_per_unit = 0.5;
  const SyntheticDrive drive = MakeSyntheticDrive(drive_options);
  const FrameEvent& event = drive.events[3];
  const Keyframe frame = MakeKeyframe(event, drive.world.cams_from_map[3], {});
  EXPECT_EQ(frame.stamp_ns, event.stamp_ns);
  EXPECT_EQ(frame.image_name, event.image_name);
  EXPECT_FALSE(frame.weak);
  EXPECT_EQ(frame.tracks, event.tracks);
  EXPECT_EQ(frame.odometry->x_m, event.odometry->x_m);
  ASSERT_TRUE(frame.base_from_camera.has_value());
  ASSERT_EQ(frame.points.size(), event.tracks.size());
  EXPECT_EQ(frame.points[5], event.features->keypoints[5].x_normalized);
  EXPECT_EQ(frame.sigmas.size(), event.tracks.size());
  EXPECT_EQ(frame.colors.size(), event.tracks.size());
  EXPECT_EQ(frame.cam_from_session.translation, drive.world.cams_from_map[3].translation);
}

TEST(MakeLightFrame, KeepsOnlyFeaturesInTracks) {
  SyntheticDriveOptions drive_options;
  drive_options.light_frames = 1;
  FrameEvent event = MakeSyntheticDrive(drive_options).events[1];
  event.tracks[0] = event.tracks[2] = 0;
  const LightFrame frame = MakeLightFrame(event);
  ASSERT_EQ(frame.tracks.size(), event.tracks.size() - 2);
  ASSERT_EQ(frame.points.size(), frame.tracks.size());
  EXPECT_EQ(frame.tracks[0], event.tracks[1]);
  EXPECT_EQ(frame.points[0], event.features->keypoints[1].x_normalized);
  EXPECT_EQ(frame.image_name, event.image_name);
}

}  // namespace
}  // namespace rovio_sfm
