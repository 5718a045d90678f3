#include "rovio_sfm/app/progress_bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace rovio_sfm {
namespace {

TEST(ProgressBar, TellsShareAndTimeLeft) {
  EXPECT_EQ(ProgressText(12, 24, 75.0), "[###############...............]  50 %  12/24  1:15 left");
}

TEST(ProgressBar, TellsNoTimeBeforeTheFirstItem) {
  EXPECT_EQ(ProgressText(0, 24, 1.0), "[..............................]   0 %  0/24");
}

TEST(ProgressBar, NothingToDoIsDone) {
  EXPECT_EQ(ProgressText(0, 0, 1.0), "[##############################] 100 %  0/0");
}

TEST(ProgressBar, DrawsAtMostTenTimesASecond) {
  std::ostringstream out;
  ProgressBar bar(100, &out);
  for (size_t i = 0; i < 100; ++i) bar.Show(i, 0.01 * static_cast<double>(i));
  const std::string text = out.str();
  EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 11);
}

}  // namespace
}  // namespace rovio_sfm
