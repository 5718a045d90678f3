#include "rovio_sfm/places/place_query.h"

#include <gtest/gtest.h>

#include <limits>

namespace rovio_sfm {
namespace {

TEST(BestPlaces, ComeBestFirstAndTheLowerIdOfEquals) {
  EXPECT_EQ(BestPlaces({1.0, 5.0, 3.0, 5.0}, 3), (std::vector<uint32_t>{1, 3, 2}));
}

TEST(BestPlaces, LeavesOutExcludedOnes) {
  constexpr double kExcluded = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(BestPlaces({kExcluded, -700.0, kExcluded}, 3), (std::vector<uint32_t>{1}));
}

TEST(BestPlaces, AreNoneOfNone) { EXPECT_TRUE(BestPlaces({}, 4).empty()); }

}  // namespace
}  // namespace rovio_sfm
