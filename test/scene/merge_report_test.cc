#include "rovio_sfm/scene/merge_report.h"

#include <gtest/gtest.h>

#include <set>

namespace rovio_sfm {
namespace {

TEST(MergeReport, NamesEveryVerdictAndKindDifferently) {
  std::set<std::string> verdicts, kinds;
  for (uint8_t i = 0; i < 5; ++i) verdicts.insert(ToString(static_cast<MergeVerdict>(i)));
  for (uint8_t i = 0; i < 3; ++i) kinds.insert(ToString(static_cast<MergeKind>(i)));
  EXPECT_EQ(verdicts.size(), 5u);
  EXPECT_EQ(kinds.size(), 3u);
  EXPECT_EQ(verdicts.count("unknown") + kinds.count("unknown"), 0u);
}

TEST(MergeReport, IsAnotherWhenAnyFieldIs) {
  MergeReport a, b;
  EXPECT_TRUE(a == b);
  b.error_after_px = 0.5;
  EXPECT_FALSE(a == b);
  b = a;
  b.query_from_other.scale = 2.0;
  EXPECT_FALSE(a == b);
  b = a;
  b.reason = "other";
  EXPECT_FALSE(a == b);
}

}  // namespace
}  // namespace rovio_sfm
