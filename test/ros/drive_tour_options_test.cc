#include <gtest/gtest.h>

#include <stdexcept>

#include "rovio_sfm/ros/drive_tour_node.h"

namespace rovio_sfm {
namespace {

std::string ErrorOf(const std::string& yaml) {
  try {
    LoadDriveTourOptions(YAML::Load(yaml));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(LoadDriveTourOptions, TheShippedFileHoldsTheDefaults) {
  YAML::Node shipped = YAML::LoadFile(std::string(ROVIO_SOURCE_DIR) + "/config/drive_tour.yaml");
  shipped["tour"] = "x.yaml";
  const DriveTourOptions loaded = LoadDriveTourOptions(shipped);
  const DriveTourOptions defaults;
  EXPECT_EQ(loaded.look, defaults.look);
  EXPECT_EQ(loaded.look_timeout_s, defaults.look_timeout_s);
  EXPECT_EQ(loaded.max_looks, defaults.max_looks);
  EXPECT_EQ(loaded.stop_timeout_s, defaults.stop_timeout_s);
  EXPECT_EQ(loaded.steer.position_tolerance_m, defaults.steer.position_tolerance_m);
  EXPECT_EQ(loaded.steer.max_turn_rad_per_s, defaults.steer.max_turn_rad_per_s);
  EXPECT_NEAR(loaded.steer.yaw_tolerance_rad, defaults.steer.yaw_tolerance_rad, 1e-3);
  EXPECT_NEAR(loaded.steer.turn_first_rad, defaults.steer.turn_first_rad, 2e-3);
}

TEST(LoadDriveTourOptions, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("{}"), "drive_tour: tour must name a YAML file of way-points");
  EXPECT_EQ(ErrorOf("{tour: x, lok: image}"), "drive_tour.lok: unknown option");
  EXPECT_EQ(ErrorOf("{tour: x, look: away}"),
            "drive_tour.look: expected one of nothing image frame");
  EXPECT_EQ(ErrorOf("{tour: x, max_looks: 0}"), "drive_tour: max_looks must be 1 … 100");
  EXPECT_EQ(ErrorOf("{tour: x, look_timeout_s: 0}"),
            "drive_tour: time-outs and max_odom_age_s must be 0.1 … 3600 s");
}

}  // namespace
}  // namespace rovio_sfm
