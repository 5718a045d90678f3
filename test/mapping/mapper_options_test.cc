#include "rovio_sfm/mapping/mapper_options.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

// The error names the option.
template <typename Change>
void ExpectRefused(const std::string& name, Change change) {
  MapperOptions options;
  change(&options);
  std::string error;
  EXPECT_FALSE(IsValid(options, &error)) << name;
  EXPECT_NE(error.find(name), std::string::npos) << error;
}

TEST(MapperOptions, TheDefaultsAreValid) {
  std::string error;
  EXPECT_TRUE(IsValid(MapperOptions{}, &error)) << error;
}

TEST(MapperOptions, RefuseValuesOutOfRangeByName) {
  ExpectRefused("max_weak_frames", [](MapperOptions* o) { o->max_weak_frames = -1; });
  ExpectRefused("max_weak_tries", [](MapperOptions* o) { o->max_weak_tries = 0; });
  ExpectRefused("pixel_sigma_px", [](MapperOptions* o) { o->pixel_sigma_px = 0.0; });
  ExpectRefused("sigma_size_px", [](MapperOptions* o) { o->sigma_size_px = 0.5; });
  ExpectRefused("sigma_exponent", [](MapperOptions* o) { o->sigma_exponent = 2.5; });
}

TEST(MapperOptions, RefuseBadPartsByTheirPath) {
  ExpectRefused("max_held_frames", [](MapperOptions* o) { o->bootstrap.max_held_frames = 3; });
  ExpectRefused("min_inliers", [](MapperOptions* o) { o->bootstrap.min_inliers = 7; });
  ExpectRefused("patience", [](MapperOptions* o) { o->bootstrap.patience = 0; });
  ExpectRefused("threshold_px", [](MapperOptions* o) { o->resect.threshold_px = 0.0; });
  ExpectRefused("min_parallax_deg", [](MapperOptions* o) { o->triangulate.min_parallax_deg = 90; });
  ExpectRefused("local_frames", [](MapperOptions* o) { o->adjust.local_frames = 1; });
  ExpectRefused("final_error_sigmas", [](MapperOptions* o) { o->prune.final_error_sigmas = 0.5; });
  ExpectRefused("min_distance_m", [](MapperOptions* o) { o->scale.min_distance_m = 0.0; });
}

TEST(MapperOptions, RefuseNumbersThatAreNone) {
  ExpectRefused("pixel_sigma_px", [](MapperOptions* o) { o->pixel_sigma_px = std::nan(""); });
  ExpectRefused("max_global_frames", [](MapperOptions* o) { o->adjust.max_global_frames = 9; });
  ExpectRefused("loss_px", [](MapperOptions* o) { o->adjust.loss_px = HUGE_VAL; });
}

TEST(MapperOptions, TheWishedAngleIsNotBelowTheSmallest) {
  ExpectRefused("wished_angle_deg", [](MapperOptions* o) {
    o->bootstrap.min_angle_deg = 10.0;
    o->bootstrap.wished_angle_deg = 9.0;
  });
}

}  // namespace
}  // namespace rovio_sfm
