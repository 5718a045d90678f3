#include "rovio_sfm/sim/http/command.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(FindCommand, KnowsTheRobotsCommands) {
  for (const char* name : {"nav", "GetStatus.cgi", "ChangeResolution.cgi", "GetMyself.cgi"}) {
    ASSERT_NE(FindCommand(name), nullptr) << name;
    EXPECT_EQ(FindCommand(name)->name, name);
  }
  EXPECT_EQ(FindCommand("Nothing.cgi"), nullptr);
  EXPECT_EQ(FindCommand(""), nullptr);
}

}  // namespace
}  // namespace rovio_sfm::sim
