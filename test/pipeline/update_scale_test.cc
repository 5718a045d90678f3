#include "rovio_sfm/pipeline/update_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/mapped_drive.h"

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
  session.set_scale({kMetresPerUnit, 0.05, "odometry"});
  EXPECT_FALSE(UpdateScale({}, false, &session));
  EXPECT_EQ(session.scale()->metres_per_unit, kMetresPerUnit);
  EXPECT_TRUE(UpdateScale({}, true, &session));
  EXPECT_NEAR(session.scale()->metres_per_unit, 1.05 * kMetresPerUnit, 2e-3);
}

TEST(UpdateScale, ReplacesAnOldScaleOutsideTwoSigma) {
  Session session = DriveWithGain(1.3);
  session.set_scale({kMetresPerUnit, 0.05, "odometry"});
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

}  // namespace
}  // namespace rovio_sfm
