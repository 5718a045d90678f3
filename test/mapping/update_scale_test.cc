#include "rovio_sfm/mapping/update_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

constexpr double kMetresPerUnit = 0.5;

Session DriveWithGain(double gain) {
  SyntheticDriveOptions options;
  options.world.motion = SyntheticMotion::kForward;
  options.world.turn_rad = 0.0;
  options.metres_per_unit = kMetresPerUnit;
  options.odometry_gain = gain;
  return PosedDrive(MakeSyntheticDrive(options));
}

TEST(UpdateScale, FindsTheScaleOfTheOdometry) {
  Session session = DriveWithGain(1.0);
  ASSERT_TRUE(UpdateScale({}, false, &session));
  EXPECT_NEAR(session.scale()->metres_per_unit, kMetresPerUnit, 1e-3);
  EXPECT_GE(session.scale()->sigma_log, ScaleOptions{}.odometry_gain_sigma);
}

TEST(UpdateScale, KeepsAnOldScaleInsideTwoSigma) {
  Session session = DriveWithGain(1.05);
  session.set_scale(MapScale{kMetresPerUnit, 0.05, "odometry"});
  EXPECT_FALSE(UpdateScale({}, false, &session));
  EXPECT_EQ(session.scale()->metres_per_unit, kMetresPerUnit);
  EXPECT_TRUE(UpdateScale({}, true, &session));
  EXPECT_NEAR(session.scale()->metres_per_unit, 1.05 * kMetresPerUnit, 2e-3);
}

TEST(UpdateScale, ReplacesAnOldScaleOutsideTwoSigma) {
  Session session = DriveWithGain(1.3);
  session.set_scale(MapScale{kMetresPerUnit, 0.05, "odometry"});
  EXPECT_TRUE(UpdateScale({}, false, &session));
  EXPECT_NEAR(session.scale()->metres_per_unit, 1.3 * kMetresPerUnit, 2e-3);
}

TEST(UpdateScale, TakesNoReferenceFromWeakFrames) {
  Session session = DriveWithGain(1.0);
  for (uint32_t i = 2; i < 16; ++i) session.SetWeak(i, true);
  EXPECT_FALSE(UpdateScale({}, true, &session));
  EXPECT_FALSE(session.scale().has_value());
}

TEST(UpdateScale, SaysNothingWithoutOdometry) {
  Session session = PosedDrive(MakeSyntheticDrive({}));
  EXPECT_FALSE(UpdateScale({}, true, &session));
  EXPECT_FALSE(session.scale().has_value());
}

// A session that looks forward over a floor kHeight map units below its cameras.
constexpr double kHeight = 0.6;

Session DriveOverFloor(const std::optional<double>& metres_per_unit = std::nullopt) {
  SyntheticDriveOptions options;
  options.world.motion = SyntheticMotion::kForward;
  options.world.num_points = 900;
  options.metres_per_unit = metres_per_unit;
  SyntheticDrive drive = MakeSyntheticDrive(options);
  Session session = MappedDrive(drive);
  Rng rng(4);
  std::vector<TrackId> tracks;
  for (const auto& [id, landmark] : session.landmarks()) tracks.push_back(id);
  for (const TrackId id : tracks) {
    const double z = rng.Uniform(0.0, 6.0);
    session.SetPosition(id, {rng.Uniform(-1.0, 1.0), kHeight + 0.02 * z, z});  // along the way
  }
  return session;
}

TEST(UpdateScale, TakesTheCameraHeightWithoutOdometry) {
  Session session = DriveOverFloor();
  ScaleOptions options;
  options.camera_height_m = 0.3;
  ASSERT_TRUE(UpdateScale(options, false, &session));
  EXPECT_EQ(session.scale()->source, "camera height");
  EXPECT_NEAR(session.scale()->metres_per_unit, 0.3 / kHeight, 0.01);
}

TEST(UpdateScale, TakesTheMoreCertainOfOdometryAndCameraHeight) {
  Session session = DriveOverFloor(kMetresPerUnit);
  for (const double camera_height_sigma : {0.001, 0.5}) {
    ScaleOptions options;
    options.camera_height_m = 0.3;
    options.camera_height_sigma = camera_height_sigma;
    ASSERT_TRUE(UpdateScale(options, true, &session));
    EXPECT_EQ(session.scale()->source, camera_height_sigma < 0.1 ? "camera height" : "odometry");
  }
}

TEST(UpdateScale, KnowsThatARaisedHeadIsHigherAboveTheFloor) {
  Session session = DriveOverFloor(kMetresPerUnit);
  Session raised(session.id(), session.drive(), session.camera());
  for (const auto& [index, keyframe] : session.keyframes()) {
    Keyframe frame = keyframe;
    frame.odometry.reset();
    if (index == 0) {
      frame.base_from_camera->translation.z() -= 0.05;
      frame.cam_from_session.translation -=
          frame.cam_from_session.rotation * Eigen::Vector3d(0.0, 0.1, 0.0);
    }
    frame.observed.assign(frame.observed.size(), 0);
    frame.num_observed = 0;
    raised.AddKeyframe(index, frame);
  }
  for (const auto& [id, landmark] : session.landmarks()) {
    raised.AddLandmark(id, landmark.position, {}, landmark.observations);
  }
  ScaleOptions options;
  options.camera_height_m = 0.25;  // of the first; the others are 0.3 m high
  ASSERT_TRUE(UpdateScale(options, false, &raised));
  EXPECT_NEAR(raised.scale()->metres_per_unit, 0.3 / kHeight, 0.02);
}

TEST(UpdateScale, IgnoresTheFloorWhereTheHeightIsNotKnown) {
  Session session = DriveOverFloor();
  EXPECT_FALSE(UpdateScale({}, true, &session));
}

}  // namespace
}  // namespace rovio_sfm
