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

}  // namespace
}  // namespace rovio_sfm
