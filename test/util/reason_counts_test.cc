#include "rovio_sfm/util/reason_counts.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(ReasonCounts, TellsTheMostFrequentFirst) {
  ReasonCounts counts, more;
  CountReason("black", &counts);
  CountReason("size", &more, 11);
  CountReason("black", &more);
  AddReasons(more, &counts);
  EXPECT_EQ(ReasonTable(counts), "      11  size\n       2  black\n");
  EXPECT_EQ(ReasonTable({}), "");
}

TEST(ReasonCounts, CountsTogetherWhatIsTooManifold) {
  ReasonCounts counts;
  for (int i = 0; i < 60; ++i) CountReason("reason " + std::to_string(i), &counts);
  CountReason("reason 3", &counts);
  EXPECT_EQ(counts.size(), 51u);
  EXPECT_EQ(counts.at("other reasons"), 10u);
  EXPECT_EQ(counts.at("reason 3"), 2u);
}

}  // namespace
}  // namespace rovio_sfm
