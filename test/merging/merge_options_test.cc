#include "rovio_sfm/merging/merge_options.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(MergeOptions, DefaultsAreValid) {
  std::string error;
  EXPECT_TRUE(MergeOptions().IsValid(&error)) << error;
}

TEST(MergeOptions, NamesOptionValueAndBound) {
  MergeOptions options;
  options.min_keyframes = 2;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "merge.min_keyframes = 2: expected 3 to 1000");
}

TEST(MergeOptions, ChecksItsGroups) {
  MergeOptions options;
  options.evidence.min_inliers = -1;
  EXPECT_FALSE(options.IsValid(nullptr));
  options = {};
  options.align.confidence = 2.0;
  EXPECT_FALSE(options.IsValid(nullptr));
}

}  // namespace
}  // namespace rovio_sfm
