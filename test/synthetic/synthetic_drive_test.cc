#include "synthetic/synthetic_drive.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(SyntheticDrive, IsConsistent) {
  SyntheticDriveOptions options;
  options.light_frames = 1;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  ASSERT_EQ(drive.events.size(), 16u);
  for (uint32_t i = 0; i < 16; ++i) {
    const FrameEvent& event = drive.events[i];
    EXPECT_EQ(event.id.index, i);
    EXPECT_EQ(event.tracks.size(), event.features->keypoints.size());
    EXPECT_GT(event.tracks.size(), 100u);
    const bool is_keyframe = event.kind == FrameKind::kKeyframe;
    EXPECT_EQ(is_keyframe, i % 2 == 0);
    EXPECT_EQ(event.features->descriptors.Count(), is_keyframe ? event.tracks.size() : 0u);
    EXPECT_EQ(event.pairs.size(), is_keyframe && i > 0 ? 1u : 0u);
    EXPECT_FALSE(event.odometry.has_value());
  }
}

TEST(SyntheticDrive, CutsAndLinksTracks) {
  SyntheticDriveOptions options;
  options.track_length = 4;
  options.with_links = true;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  for (size_t i = 1; i < 16; ++i) {
    EXPECT_GT(drive.events[i].links.size(), 10u);
    EXPECT_LT(drive.events[i].links.size(), drive.events[i].tracks.size());
  }
}

TEST(SyntheticDrive, OdometryMeasuresTheWayInMetres) {
  SyntheticDriveOptions options;
  options.metres_per_unit = 0.5;
  options.odometry_gain = 1.1;
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  const double angle_rad = options.world.step / options.world.depth;
  const double radius_m = 0.5 * options.world.depth - 0.1;  // of the base's circle
  const double way_m = 2.0 * radius_m * std::sin(0.5 * angle_rad);
  const OdometrySample& first = *drive.events[0].odometry;
  const OdometrySample& second = *drive.events[1].odometry;
  EXPECT_NEAR(first.x_m, 0.0, 1e-12);
  EXPECT_NEAR(std::hypot(second.x_m, second.y_m), 1.1 * (way_m + 0.2 * std::sin(0.5 * angle_rad)),
              0.02);
  EXPECT_NEAR(std::abs(second.yaw_rad), angle_rad, 1e-9);
}

TEST(MeasureTrajectory, IsZeroForTheTruthInAnyGauge) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  const Sim3 b_from_a{0.3, Eigen::Quaterniond(0.8, 0.3, 0.1, -0.2).normalized(), {1, 2, 3}};
  FrameBlock block(5);
  for (uint32_t i = 0; i < 5; ++i) {
    block[i].index = i;
    block[i].cam_from_session = TransformCamera(b_from_a, drive.world.cams_from_map[i]);
  }
  SessionSnapshot session;
  EXPECT_FALSE(MeasureTrajectory(session, drive.world));
  session.frames = {std::make_shared<const FrameBlock>(block)};
  const auto error = MeasureTrajectory(session, drive.world);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->num_frames, 5u);
  EXPECT_LT(error->max_distance, 1e-9);
  EXPECT_LT(error->max_rotation_rad, 1e-7);
}

}  // namespace
}  // namespace rovio_sfm
