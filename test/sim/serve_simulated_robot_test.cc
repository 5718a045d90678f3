#include "rovio_sfm/sim/serve_simulated_robot.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rovio_sfm::sim {
namespace {

TEST(ServeSimulatedRobot, NamesAMissingTour) {
  ServeRobotOptions options;
  options.config_folder = "/nowhere";
  options.tour = "visionlab";
  EXPECT_THROW(ServeSimulatedRobot(options), std::runtime_error);
}

TEST(ServeRobotOptions, RefusesAPathAsATour) {
  ServeRobotOptions options;
  options.tour = "../visionlab";
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("tour"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
