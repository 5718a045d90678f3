#include "rovio_sfm/util/union_find.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace rovio_sfm {
namespace {

TEST(UnionFind, UnseenIdsAreTheirOwnRoot) {
  const UnionFind<int> sets;
  EXPECT_EQ(sets.Find(42), 42);
}

TEST(UnionFind, TheSmallestIdIsTheRoot) {
  UnionFind<int> sets;
  EXPECT_EQ(sets.Union(5, 3), 3);
  EXPECT_EQ(sets.Union(7, 5), 3);
  EXPECT_EQ(sets.Union(1, 7), 1);
  for (const int id : {1, 3, 5, 7}) EXPECT_EQ(sets.Find(id), 1);
  EXPECT_EQ(sets.Find(4), 4);
}

TEST(UnionFind, RootsDoNotDependOnTheOrder) {
  std::vector<std::pair<int, int>> links = {{1, 2}, {3, 4}, {2, 4}, {9, 8}, {8, 3}};
  UnionFind<int> forward, backward;
  for (const auto& [a, b] : links) forward.Union(a, b);
  for (auto it = links.rbegin(); it != links.rend(); ++it) backward.Union(it->second, it->first);
  for (int id = 0; id < 10; ++id) EXPECT_EQ(forward.Find(id), backward.Find(id));
}

TEST(UnionFind, UnitingTwiceChangesNothing) {
  UnionFind<int> sets;
  sets.Union(1, 2);
  EXPECT_EQ(sets.Union(2, 1), 1);
  EXPECT_EQ(sets.Union(1, 1), 1);
  EXPECT_EQ(sets.Find(2), 1);
}

}  // namespace
}  // namespace rovio_sfm
