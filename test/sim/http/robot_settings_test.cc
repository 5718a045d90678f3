#include "rovio_sfm/sim/http/robot_settings.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(RobotSettings, InvalidResolutionIsStoredAndNotApplied) {
  RobotSettings settings;
  settings.SetResolution(3);
  settings.SetResolution(7);
  EXPECT_EQ(settings.resolution, 7);
  EXPECT_EQ(settings.applied.resolution, 3);
}

TEST(RobotSettings, InvalidRatioIsIgnored) {
  RobotSettings settings;
  settings.SetCompressionRatio(3);
  EXPECT_EQ(settings.compression_ratio, 1);
  settings.SetCompressionRatio(2);
  EXPECT_EQ(settings.applied.compression_ratio, 2);
}

TEST(RobotSettings, FrameRateActsWithinOneToThirty) {
  RobotSettings settings;
  settings.SetFrameRate(10);
  settings.SetFrameRate(0);
  EXPECT_EQ(settings.applied.frame_rate_hz, 10);
  settings.SetFrameRate(99);
  EXPECT_EQ(settings.applied.frame_rate_hz, 30);
  settings.SetFrameRate(5);
  settings.SetFrameRate(100);
  EXPECT_EQ(settings.applied.frame_rate_hz, 5);
  EXPECT_EQ(settings.frame_rate_hz, 100);
}

TEST(RobotSettings, BrightnessActsFromZeroToSix) {
  RobotSettings settings;
  settings.SetBrightness(2);
  settings.SetBrightness(9);
  EXPECT_EQ(settings.applied.brightness, 2);
}

}  // namespace
}  // namespace rovio_sfm::sim
