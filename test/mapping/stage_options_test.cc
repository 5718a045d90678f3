#include "rovio_sfm/mapping/stage_options.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

TEST(StageOptions, TurnPixelsIntoSigmasAndDegreesIntoRadians) {
  MapperOptions options;
  options.pixel_sigma_px = 2.0;
  options.triangulate = {3.0, 5.0};
  options.prune.max_error_px = 8.0;
  EXPECT_DOUBLE_EQ(TriangulateOptionsOf(options).min_parallax_rad, M_PI / 60.0);
  EXPECT_DOUBLE_EQ(TriangulateOptionsOf(options).max_error_sigmas, 2.5);
  EXPECT_DOUBLE_EQ(PruneOptionsOf(options).min_parallax_rad, M_PI / 60.0);
  EXPECT_DOUBLE_EQ(PruneOptionsOf(options).max_error_sigmas, 4.0);
}

TEST(PlanarMotionOf, SpeaksOnlyWhereItIsOn_AndInMetresWhereThereIsAScale) {
  AdjustOptions options;
  const MapScale scale{0.25, 0.1, "odometry"};
  EXPECT_FALSE(PlanarMotionOf(options, scale));
  options.planar_motion = true;
  options.tilt_sigma_deg = 1.0;
  options.height_sigma_m = 0.01;
  const auto metric = PlanarMotionOf(options, scale), unscaled = PlanarMotionOf(options, {});
  ASSERT_TRUE(metric && unscaled);
  EXPECT_DOUBLE_EQ(metric->tilt_sigma_rad, M_PI / 180.0);
  EXPECT_DOUBLE_EQ(metric->height_sigma_m, 0.01);
  EXPECT_EQ(metric->metres_per_unit, 0.25);
  EXPECT_FALSE(unscaled->metres_per_unit);
}

}  // namespace
}  // namespace rovio_sfm
