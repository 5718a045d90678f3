#include "rovio_sfm/sim/run_rovio_sim.h"

#include <gtest/gtest.h>

#include <vector>

namespace rovio_sfm::sim {
namespace {

int RunProgram(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "rovio_sim");
  return RunRovioSim(static_cast<int>(arguments.size()), arguments.data());
}

TEST(RunRovioSim, HelpSucceeds) { EXPECT_EQ(RunProgram({"--help"}), 0); }

TEST(RunRovioSim, RefusesUnknownArgumentsAndMissingModes) {
  EXPECT_THROW(RunProgram({"--nonsense"}), std::runtime_error);
  EXPECT_NE(RunProgram({}), 0);
  EXPECT_NE(RunProgram({"--images", "/nowhere", "--port", "0"}), 0);
}

}  // namespace
}  // namespace rovio_sfm::sim
