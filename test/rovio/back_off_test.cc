#include "rovio_sfm/rovio/back_off.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(BackOff, DoublesUpToItsCapAndBeginsAnewAfterASuccess) {
  BackOffOptions options;
  options.first_delay_s = 0.5;
  options.max_delay_s = 3.0;
  BackOff back_off(options);
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 0.5);
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 1.0);
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 2.0);
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 3.0);
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 3.0);
  back_off.Reset();
  EXPECT_DOUBLE_EQ(back_off.NextDelaySeconds(), 0.5);
}

TEST(BackOffOptions, RefusesNoWaitAtAll) {
  std::string error;
  BackOffOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.first_delay_s = 0.0;
  EXPECT_FALSE(IsValid(options, &error));
}

}  // namespace
}  // namespace rovio_sfm
