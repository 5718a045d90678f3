#include "rovio_sfm/merging/merge_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(MergeOptions, DefaultsAreValid) {
  std::string error;
  EXPECT_TRUE(IsValid(MergeOptions(), &error)) << error;
}

TEST(MergeOptions, NamesOptionValueAndBound) {
  MergeOptions options;
  options.min_keyframes = 2;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "min_keyframes = 2: expected 3 to 1000");
}

TEST(MergeOptions, ChecksItsGroups) {
  MergeOptions options;
  options.evidence.min_inliers = -1;
  EXPECT_FALSE(IsValid(options));
  options = {};
  options.align.confidence = 2.0;
  EXPECT_FALSE(IsValid(options));
}

}  // namespace
}  // namespace rovio_sfm
