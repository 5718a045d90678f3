#include "rovio_sfm/report/drive_names.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(DriveNames, AreTheRobotsWhereEachHasOne) {
  const auto names = DriveNames({{"one", 5, 6}, {"two", 5, 6}});
  EXPECT_EQ(names.at({"one", 5, 6}), "one");
  EXPECT_EQ(names.at({"two", 5, 6}), "two");
}

TEST(DriveNames, TellDrivesOfOneRobotApart) {
  const auto names = DriveNames({{"one", 5, 6}, {"one", 5, 7}, {"two", 5, 6}});
  EXPECT_EQ(names.at({"one", 5, 6}), "one-5-6");
  EXPECT_EQ(names.at({"one", 5, 7}), "one-5-7");
  EXPECT_EQ(names.at({"two", 5, 6}), "two");
}

}  // namespace
}  // namespace rovio_sfm
