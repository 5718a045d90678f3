#include "rovio_sfm/scene/link_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kLargest = std::numeric_limits<uint32_t>::max();

TEST(LinkList, GivesBackWhatCame) {
  Rng rng(3);
  std::vector<FeatureLink> links;
  for (uint32_t i = 0; i < 1000; ++i) {
    const auto below = [&](uint32_t end) { return rng.UniformInt(end); };
    links.push_back({{{1 + below(3)}, below(500), below(1000)}, {{7}, below(500), below(70000)}});
  }
  EXPECT_EQ(LinkList(links).List(), links);
  std::sort(links.begin(), links.end());
  EXPECT_EQ(LinkList(links).List(), links);
  EXPECT_EQ(LinkList(links).size(), 1000u);
}

TEST(LinkList, TakesEveryNumber) {
  const std::vector<FeatureLink> links = {{{{kLargest}, 0, kLargest}, {{0}, kLargest, 0}},
                                          {{{0}, kLargest, 1u << 31}, {{kLargest}, 0, 1}},
                                          {{{1}, 127, 128}, {{64}, 63, (1u << 31) - 1}}};
  EXPECT_EQ(LinkList(links).List(), links);
}

TEST(LinkList, IsEqualWhereTheLinksAre) {
  const std::vector<FeatureLink> links = {{{{1}, 2, 3}, {{2}, 5, 6}}};
  EXPECT_TRUE(LinkList(links) == LinkList(links));
  EXPECT_FALSE(LinkList(links) == LinkList());
  EXPECT_TRUE(LinkList().empty());
  EXPECT_TRUE(LinkList().List().empty());
}

}  // namespace
}  // namespace rovio_sfm
