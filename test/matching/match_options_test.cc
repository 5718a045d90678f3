#include "rovio_sfm/matching/match_options.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(MatchOptions, NamesTheBadOption) {
  MatchOptions options;
  options.checks = 0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "match.checks = 0: expected 1 to 10000");
}

}  // namespace
}  // namespace rovio_sfm
