#include "rovio_sfm/app/drive_tour_options.h"

#include <gtest/gtest.h>

#include <stdexcept>

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

TEST(LoadDriveTourOptions, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("{}"), "drive_tour.tour = : expected a YAML file of way-points");
  EXPECT_EQ(ErrorOf("{tour: x, lok: image}"), "drive_tour.lok: unknown key");
  EXPECT_EQ(ErrorOf("{tour: x, look: away}"),
            "drive_tour.look: expected image, frame or nothing, not 'away'");
  EXPECT_EQ(ErrorOf("{tour: x, max_looks: 0}"), "drive_tour.max_looks = 0: expected 1 to 100");
  EXPECT_EQ(ErrorOf("{tour: x, look_timeout_s: 0}"),
            "drive_tour.look_timeout_s = 0: expected 0.1 to 3600");
}

}  // namespace
}  // namespace rovio_sfm
