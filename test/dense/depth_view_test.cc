#include "rovio_sfm/dense/depth_view.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

TEST(MakeDepthView, HalvesThePictureAndItsCamera) {
  const DepthView view = ViewOfWall(0.0, 0.0, 2.0);
  EXPECT_EQ(view.grey.size(), cv::Size(160, 120));
  EXPECT_EQ(view.pixel_from_ray(0, 0), 150.0);
  EXPECT_EQ(view.pixel_from_ray(0, 2), 79.5);
  EXPECT_EQ(view.pixel_from_ray(1, 2), 59.5);
}

TEST(MakeDepthView, NamesASizeThatIsNotTheCameras) {
  std::vector<uint8_t> png;
  cv::imencode(".png", cv::Mat(10, 20, CV_8UC3, cv::Scalar::all(9)), png);
  try {
    MakeDepthView(png, SmallCamera());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("20 x 10: expected 320 x 240"), std::string::npos);
  }
  EXPECT_THROW(MakeDepthView({1, 2, 3}, SmallCamera()), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
