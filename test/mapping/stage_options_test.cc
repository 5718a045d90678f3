#include "rovio_sfm/mapping/stage_options.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

TEST(LandmarkLimits, TurnPixelsIntoSigmasAndDegreesIntoRadians) {
  MapperOptions options;
  options.pixel_sigma_px = 2.0;
  options.triangulate = {3.0, 5.0};
  options.prune.max_error_px = 8.0;
  EXPECT_DOUBLE_EQ(TriangulationLimits(options).min_parallax_rad, M_PI / 60.0);
  EXPECT_DOUBLE_EQ(TriangulationLimits(options).max_error_sigmas, 2.5);
  EXPECT_DOUBLE_EQ(PruningLimits(options).min_parallax_rad, M_PI / 60.0);
  EXPECT_DOUBLE_EQ(PruningLimits(options).max_error_sigmas, 4.0);
}

}  // namespace
}  // namespace rovio_sfm
