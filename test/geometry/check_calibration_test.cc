#include "rovio_sfm/geometry/check_calibration.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(IsValidCalibration, WantsTheCentreInThePicture) {
  Camera camera;
  camera.fx = camera.fy = 500.0, camera.cx = 320.0, camera.cy = 240.0;
  camera.width = 640, camera.height = 480;
  std::string error;
  EXPECT_TRUE(IsValidCalibration(camera, &error)) << error;
  camera.cy = 481.0;
  EXPECT_TRUE(camera.IsValid(&error)) << error;  // a correction may lead there
  EXPECT_FALSE(IsValidCalibration(camera, &error));
  EXPECT_EQ(error, "camera cy = 481: expected 0 to 480 px, in the picture");
  camera.cx = -3.0;
  EXPECT_FALSE(IsValidCalibration(camera, &error));
  EXPECT_EQ(error, "camera cx = -3: expected 0 to 640 px, in the picture");
  camera.fx = 0.0;
  EXPECT_FALSE(IsValidCalibration(camera, &error));
  EXPECT_EQ(error.rfind("camera fx", 0), 0u) << error;
}

}  // namespace
}  // namespace rovio_sfm
