#include "rovio_sfm/sim/config_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "util/temporary_folder.h"

namespace rovio_sfm::sim {
namespace {

TEST(FindConfigFolder, TakesTheAskedOne) {
  const TemporaryFolder temp;
  temp.Write("worlds/a.yaml", "");
  temp.Write("tours/a.yaml", "");
  EXPECT_EQ(FindConfigFolder(temp.Path()), temp.Path());
}

TEST(FindConfigFolder, FindsTheShippedOne) {
  EXPECT_TRUE(std::filesystem::exists(FindConfigFolder("") + "/tours/visionlab.yaml"));
}

TEST(FindConfigFolder, SaysWhereItLooked) {
  try {
    FindConfigFolder("/nowhere");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere"), std::string::npos);
  }
}

}  // namespace
}  // namespace rovio_sfm::sim
