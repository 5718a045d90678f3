#include "rovio_sfm/merging/group_pairs.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

OverlapPair PairWith(const FrameId& other, size_t num_inliers) {
  OverlapPair pair;
  pair.other = other;
  pair.inliers.resize(num_inliers);
  return pair;
}

struct ThreeSessions {
  ThreeSessions() {
    for (const char* robot : {"a", "b", "c"}) {
      table.Open({robot, 1, 0}, MakeSyntheticCamera()).AddKeyframe(4, {});
    }
  }

  SessionTable table;
};

TEST(GroupPairs, GivesEachSessionItsPairsAndLeavesOutWhatNoneHolds) {
  ThreeSessions three;
  PlaceMatch match;
  match.pairs = {PairWith({{"b", 1, 0}, 4}, 9), PairWith({{"a", 1, 0}, 4}, 5),
                 PairWith({{"a", 1, 0}, 5}, 50)};
  const PairsBySession pairs = GroupPairs(match, three.table);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs.at({1}).size(), 1u);
  EXPECT_EQ(pairs.at({1})[0].inliers.size(), 5u);
  EXPECT_EQ(pairs.at({2})[0].inliers.size(), 9u);
}

TEST(FindRichest, CountsInliersAndGivesTiesToTheSmallerId) {
  const FrameId any{{"a", 1, 0}, 4};
  EXPECT_EQ(FindRichest({{{1}, {PairWith(any, 5)}}, {{2}, {PairWith(any, 9)}}}).value, 2u);
  EXPECT_EQ(FindRichest({{{1}, {PairWith(any, 9)}}, {{2}, {PairWith(any, 9)}}}).value, 1u);
  EXPECT_EQ(FindRichest({{{3}, {PairWith(any, 0)}}}).value, 3u);
}

}  // namespace
}  // namespace rovio_sfm
