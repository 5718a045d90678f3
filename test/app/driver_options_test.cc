#include "rovio_sfm/app/driver_options.h"

#include <gtest/gtest.h>

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

TEST(LoadDriverOptions, TheShippedFileHoldsTheDefaults) {
  YAML::Node shipped = YAML::LoadFile(std::string(ROVIO_SOURCE_DIR) + "/config/rovio_driver.yaml");
  shipped["host"] = "rovio";
  const DriverOptions loaded = LoadDriverOptions(shipped, "rovio1");
  const DriverOptions defaults = Load("host: rovio");
  EXPECT_EQ(loaded.http.first_byte_timeout_s, defaults.http.first_byte_timeout_s);
  EXPECT_EQ(loaded.images.parser.max_part_bytes, defaults.images.parser.max_part_bytes);
  EXPECT_EQ(loaded.drive.speed_m_per_s, defaults.drive.speed_m_per_s);
  EXPECT_EQ(loaded.drive.max_command_age_ns, defaults.drive.max_command_age_ns);
  EXPECT_EQ(loaded.odometry.wheel_sign, defaults.odometry.wheel_sign);
  EXPECT_NEAR(loaded.odometry.front_roll_angle_rad, defaults.odometry.front_roll_angle_rad, 1e-12);
  EXPECT_EQ(loaded.stationary.rest_ns, defaults.stationary.rest_ns);
  EXPECT_EQ(loaded.head.camera_height_up_m, defaults.head.camera_height_up_m);
  EXPECT_EQ(loaded.reports.wanted_settings->frame_rate,
            defaults.reports.wanted_settings->frame_rate);
}

TEST(LoadDriverOptions, FramesBearTheRobotsName) {
  EXPECT_EQ(Load("host: rovio").frames.camera_optical, "rovio1/camera_optical");
  EXPECT_EQ(Load("host: rovio", "").frames.odom, "odom");
  EXPECT_EQ(Load("{host: rovio, frame_id: eye}").frames.camera_optical, "eye");
}

TEST(LoadDriverOptions, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("{}"),
            "rovio_driver: host must be a name or an IPv4 address, without scheme, port or path");
  EXPECT_EQ(ErrorOf("{host: rovio, hots: x}"), "rovio_driver.hots: unknown option");
  EXPECT_EQ(ErrorOf("{host: rovio, port: many}"), "rovio_driver.port: expected a whole number");
  EXPECT_EQ(ErrorOf("{host: rovio, port: 99999}"), "rovio_driver: port must be 1 … 65535");
  EXPECT_EQ(ErrorOf("{host: rovio, capture_mode: still}"),
            "rovio_driver.capture_mode: expected one of stream stationary, not 'still'");
  EXPECT_EQ(ErrorOf("{host: rovio, odometry: {wheel_sign: [1, 1]}}"),
            "rovio_driver.odometry.wheel_sign: expected 3 numbers");
  EXPECT_EQ(ErrorOf("{host: rovio, camera: {resolution: 7}}"),
            "rovio_driver: resolution is 7, must be 0 … 3");
}

TEST(LoadDriverOptions, TheCameraIsLeftAloneOnRequest) {
  EXPECT_FALSE(Load("{host: rovio, camera: {configure: false}}").reports.wanted_settings);
}

}  // namespace
}  // namespace rovio_sfm
