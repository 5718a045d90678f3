#include "rovio_sfm/app/odometry_buffer.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

StampedOdometry At(int64_t stamp_ns, double x_m) { return {stamp_ns, {x_m, 0.0, 0.0, {}}}; }

TEST(OdometryBuffer, InterpolatesBetweenNeighbours) {
  OdometryBuffer buffer(1000, 100);
  buffer.Add(At(100, 1.0));
  buffer.Add(At(200, 2.0));
  ASSERT_TRUE(buffer.At(150));
  EXPECT_DOUBLE_EQ(buffer.At(150)->x_m, 1.5);
}

TEST(OdometryBuffer, GivesNothingOutsideOrInAGap) {
  OdometryBuffer buffer(1000, 100);
  EXPECT_FALSE(buffer.At(100));
  buffer.Add(At(100, 1.0));
  buffer.Add(At(300, 2.0));
  EXPECT_FALSE(buffer.At(50));
  EXPECT_FALSE(buffer.At(200));
  EXPECT_FALSE(buffer.At(301));
}

TEST(OdometryBuffer, CoversWhatLaterSamplesCannotChange) {
  OdometryBuffer buffer(1000, 100);
  EXPECT_FALSE(buffer.Covers(0));
  buffer.Add(At(100, 1.0));
  EXPECT_TRUE(buffer.Covers(100));
  EXPECT_FALSE(buffer.Covers(101));
}

TEST(OdometryBuffer, ForgetsWhatCameBeforeTimeJumpedBack) {
  OdometryBuffer buffer(1000, 1000);
  buffer.Add(At(2'000'000'500, 1.0));
  buffer.Add(At(100, 2.0));
  EXPECT_FALSE(buffer.Covers(500));
  ASSERT_TRUE(buffer.At(100));
  EXPECT_DOUBLE_EQ(buffer.At(100)->x_m, 2.0);
}

TEST(OdometryBuffer, PassesOverRepeatedAndLateSamples) {
  OdometryBuffer buffer(1000, 1000);
  buffer.Add(At(400, 1.0));
  buffer.Add(At(500, 2.0));
  buffer.Add(At(500, 7.0));
  buffer.Add(At(450, 7.0));
  ASSERT_TRUE(buffer.At(450));
  EXPECT_DOUBLE_EQ(buffer.At(450)->x_m, 1.5);
}

TEST(OdometryBuffer, ForgetsOldSamplesButKeepsItsMemory) {
  OdometryBuffer buffer(100, 10);
  for (int64_t stamp_ns = 0; stamp_ns <= 1000; stamp_ns += 10) {
    buffer.Add(At(stamp_ns, static_cast<double>(stamp_ns)));
  }
  EXPECT_FALSE(buffer.At(0));
  ASSERT_TRUE(buffer.At(905));
  EXPECT_DOUBLE_EQ(buffer.At(905)->x_m, 905.0);
}

}  // namespace
}  // namespace rovio_sfm
