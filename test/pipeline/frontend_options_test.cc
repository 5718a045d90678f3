#include "rovio_sfm/pipeline/frontend_options.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

std::string ErrorOf(const FrontendOptions& options) {
  std::string error;
  return options.IsValid(&error) ? "" : error;
}

TEST(FrontendOptions, DefaultsAreValid) { EXPECT_EQ(ErrorOf({}), ""); }

TEST(FrontendOptions, NamesTheBadOptionOfANestedGroup) {
  FrontendOptions options;
  options.light.flow.levels = 99;
  EXPECT_EQ(ErrorOf(options), "flow.levels = 99: expected 0 to 6");
  options = {};
  options.pair.max_ratio = 2.0f;
  EXPECT_EQ(ErrorOf(options), "pair.max_ratio = 2: expected 0.1 to 1");
}

TEST(FrontendOptions, TracksMustReachAsFarBackAsMatches) {
  FrontendOptions options;
  options.recursion.max_frames = options.track.remembered_frames + 1;
  EXPECT_NE(ErrorOf(options), "");
}

}  // namespace
}  // namespace rovio_sfm
