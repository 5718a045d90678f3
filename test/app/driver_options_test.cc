#include "rovio_sfm/app/driver_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rovio_sfm {
namespace {

DriverOptions Load(const std::string& yaml, const std::string& robot = "rovio1") {
  return LoadDriverOptions(YAML::Load(yaml), robot);
}

std::string ErrorOf(const std::string& yaml) {
  try {
    Load(yaml);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(LoadDriverOptions, FramesBearTheRobotsName) {
  EXPECT_EQ(Load("host: rovio").frames.camera_optical, "rovio1/camera_optical");
  EXPECT_EQ(Load("host: rovio", "").frames.odom, "odom");
  EXPECT_EQ(Load("{host: rovio, frame_id: eye}").frames.camera_optical, "eye");
}

TEST(LoadDriverOptions, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("{}"),
            "rovio_driver.host = : expected a name or IPv4 address, without scheme, port or "
            "path");
  EXPECT_EQ(ErrorOf("{host: rovio, hots: x}"), "rovio_driver.hots: unknown key");
  EXPECT_EQ(ErrorOf("{host: rovio, port: many}"),
            "rovio_driver.port: expected a whole number, not 'many'");
  EXPECT_EQ(ErrorOf("{host: rovio, port: 99999}"),
            "rovio_driver.port = 99999: expected 1 to 65535");
  EXPECT_EQ(ErrorOf("{host: rovio, capture_mode: still}"),
            "rovio_driver.capture_mode: expected stream or stationary, not 'still'");
  EXPECT_EQ(ErrorOf("{host: rovio, odometry: {wheel_sign: [1, 1]}}"),
            "rovio_driver.odometry.wheel_sign: expected 3 numbers");
  EXPECT_EQ(ErrorOf("{host: rovio, camera: {resolution: 7}}"),
            "rovio_driver.camera.resolution = 7: expected 0 to 3");
}

TEST(LoadDriverOptions, OneBackOffIsForImagesAndReports) {
  const DriverOptions options = Load("{host: rovio, back_off: {first_delay_s: 0.5}}");
  EXPECT_EQ(options.images.back_off.first_delay_s, 0.5);
  EXPECT_EQ(options.reports.back_off.first_delay_s, 0.5);
}

TEST(LoadDriverOptions, TakesDegreesAndSeconds) {
  const DriverOptions options =
      Load("{host: rovio, stationary_rest_s: 0.25, odometry: {front_roll_angle_deg: 45}}");
  EXPECT_EQ(options.stationary.rest_ns, 250000000);
  EXPECT_NEAR(options.odometry.front_roll_angle_rad, M_PI / 4.0, 1e-15);
}

TEST(LoadDriverOptions, TheCameraIsLeftAloneOnRequest) {
  EXPECT_FALSE(Load("{host: rovio, camera: {configure: false}}").reports.wanted_settings);
}

}  // namespace
}  // namespace rovio_sfm
