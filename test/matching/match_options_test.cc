#include "rovio_sfm/matching/match_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(MatchOptions, NamesTheBadOption) {
  MatchOptions options;
  options.checks = 0;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "checks = 0: expected 1 to 10000");
}

}  // namespace
}  // namespace rovio_sfm
