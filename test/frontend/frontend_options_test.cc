#include "rovio_sfm/frontend/frontend_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

std::string ErrorOf(const FrontendOptions& options) {
  std::string error;
  return IsValid(options, &error) ? "" : error;
}

TEST(FrontendOptions, DefaultsAreValid) { EXPECT_EQ(ErrorOf({}), ""); }

TEST(FrontendOptions, NamesTheBadOptionOfANestedGroup) {
  FrontendOptions options;
  options.light.flow.levels = 99;
  EXPECT_EQ(ErrorOf(options), "light.flow.levels = 99: expected 0 to 6");
  options = {};
  options.pair.max_ratio = 2.0f;
  EXPECT_EQ(ErrorOf(options), "pair.max_ratio = 2: expected 0.1 to 1");
}

TEST(FrontendOptions, TracksMustReachAsFarBackAsMatches) {
  FrontendOptions options;
  options.recursion.max_frames = options.track.remembered_frames + 1;
  EXPECT_NE(ErrorOf(options), "");
}

std::string ErrorOfChange(const FrontendOptions& next) {
  std::string error;
  return MayFollow({}, next, &error) ? "" : error;
}

TEST(FrontendOptions, ThresholdsMayChangeWithinADrive) {
  FrontendOptions next;
  next.pair.verify.threshold_px = 2.0;
  next.recursion.max_frames = 3;
  next.light.flow.max_backward_error_px = 1.0;
  EXPECT_EQ(ErrorOfChange(next), "");
}

TEST(FrontendOptions, WhatADriveIsBuiltWithMayNotChange) {
  FrontendOptions next;
  next.extract.type = DescriptorType::kOrb;
  EXPECT_EQ(ErrorOfChange(next),
            "frontend.extract.type: expected no change while the frontend runs");
  next = {};
  next.choose.mode = KeyframeMode::kParallax;
  EXPECT_NE(ErrorOfChange(next), "");
  next = {};
  next.light.flow.levels = 2;
  EXPECT_NE(ErrorOfChange(next), "");
}

TEST(FrontendOptions, InvalidOnesMayNotFollow) {
  FrontendOptions next;
  next.choose.spoilt_share = next.choose.blurred_share + 0.1;
  EXPECT_NE(ErrorOfChange(next).find("spoilt_share"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
