#include "rovio_sfm/sim/http/nav_library_actions.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

class NavLibraryActions : public testing::Test {
 protected:
  std::string Run(long action, const std::string& query = "") {
    return RunNavLibraryAction(action, Parameters::Parse(query), memory_);
  }

  Guarded<NavMemory> memory_;
};

TEST_F(NavLibraryActions, PathsAreKeptByName) {
  EXPECT_EQ(Run(4, "name=a"), "11");
  EXPECT_EQ(Run(2), "0");
  EXPECT_EQ(Run(4), "10");
  EXPECT_EQ(Run(4, "name=a"), "0|total_wp=0|quality=0|endpoints_dropped=0");
  EXPECT_EQ(Run(3), "11");
  EXPECT_EQ(Run(11, "name=a&newname=b"), "0");
  EXPECT_EQ(Run(6), "0|b");
  EXPECT_EQ(Run(7, "name=a"), "9");
  EXPECT_EQ(Run(8, "name=b"), "3");
  EXPECT_EQ(Run(5, "name=b"), "0");
  EXPECT_EQ(Run(5, "name=b"), "9");
  EXPECT_EQ(Run(6), "0");
}

TEST_F(NavLibraryActions, ParametersAreStoredByIndex) {
  EXPECT_EQ(Run(23, "index=3&value=-7"), "0");
  EXPECT_EQ(Run(24, "index=3"), "0|v3=-7");
  EXPECT_EQ(Run(24).substr(0, 21), "0|v0=0|v1=0|v2=0|v3=-");
  EXPECT_EQ(Run(23, "index=20&value=1"), "22");
  EXPECT_EQ(Run(23, "index=1&value=99999999999"), "22");
  EXPECT_EQ(Run(23, "index=1"), "23");
  EXPECT_EQ(Run(24, "index=-1"), "22");
}

TEST_F(NavLibraryActions, TuningIsReadBack) {
  EXPECT_EQ(Run(15, "Forward=8"), "0");
  EXPECT_EQ(Run(16).substr(0, 31), "0\n | LeftRight = 5\n | Forward =");
  EXPECT_NE(Run(16).find("Forward = 8"), std::string::npos);
}

TEST_F(NavLibraryActions, UnknownOnesGetTheirCode) {
  EXPECT_EQ(Run(-1), "4");
  EXPECT_EQ(Run(28), "4");
  EXPECT_EQ(Run(26), "3");
  EXPECT_EQ(Run(21), "0");
  EXPECT_EQ(Run(9), "0");
}

}  // namespace
}  // namespace rovio_sfm::sim
