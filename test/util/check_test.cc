#include "rovio_sfm/util/check.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(Check, PassesAndEvaluatesOnce) {
  int count = 0;
  ROVIO_CHECK(++count == 1);
  EXPECT_EQ(count, 1);
}

TEST(CheckDeathTest, EndsTheProgramWithConditionAndMessage) {
  EXPECT_DEATH(ROVIO_CHECK(1 + 1 == 3, "sums are off"),
               "check_test.cc.*1 \\+ 1 == 3: sums are off");
  EXPECT_DEATH(ROVIO_CHECK(false), "check failed: false");
}

}  // namespace
}  // namespace rovio_sfm
