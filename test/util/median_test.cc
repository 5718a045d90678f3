#include "rovio_sfm/util/median.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(Median, IsTheMiddleValueInAnyOrder) {
  EXPECT_EQ(Median<double>({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(Median<int>({5}), 5);
}

TEST(Median, OfAnEvenNumberIsTheUpperOne) { EXPECT_EQ(Median<float>({4, 1, 3, 2}), 3.0f); }

TEST(MedianDeathTest, RefusesAnEmptyList) { EXPECT_DEATH(Median<double>({}), "empty"); }

}  // namespace
}  // namespace rovio_sfm
