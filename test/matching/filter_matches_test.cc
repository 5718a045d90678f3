#include "rovio_sfm/matching/filter_matches.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(FilterByRatio, KeepsClearMatches) {
  const auto kept = FilterByRatio({{0, 0, 10, 0.5f}, {1, 1, 10, 0.9f}, {2, 2, 10, 0.8f}}, 0.8f);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[1].a, 2u);
}

TEST(FilterByMeanDistance, DropsWhatIsFarBeyondTheMean) {
  const std::vector<FeatureMatch> matches = {{0, 0, 10, 0}, {1, 1, 10, 0}, {2, 2, 40, 0}};
  EXPECT_EQ(FilterByMeanDistance(matches, 1.5f).size(), 2u);
  EXPECT_EQ(FilterByMeanDistance(matches, 2.0f).size(), 3u);
}

TEST(FilterOneToOne, KeepsTheNearestOfEachFeature) {
  const auto kept =
      FilterOneToOne({{7, 0, 30, 0.1f}, {7, 1, 20, 0.5f}, {8, 2, 50, 0.1f}, {9, 2, 40, 0.1f}});
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].b, 1u);
  EXPECT_EQ(kept[1].a, 9u);
}

TEST(FilterOneToOne, BreaksTiesBySmallerIndex) {
  const auto kept = FilterOneToOne({{7, 4, 20, 0.5f}, {7, 3, 20, 0.5f}});
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].b, 3u);
}

TEST(Filters, OfNothingAreNothing) {
  EXPECT_TRUE(FilterByRatio({}, 0.8f).empty());
  EXPECT_TRUE(FilterByMeanDistance({}, 1.0f).empty());
  EXPECT_TRUE(FilterOneToOne({}).empty());
}

}  // namespace
}  // namespace rovio_sfm
