#include "rovio_sfm/sim/world/draw_prints.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(DrawText, LeavesTheGroundBetweenLetters) {
  TextureSpec spec;
  spec.width_px = spec.height_px = 256;
  spec.accent = {0, 0, 0};
  Rng rng(1);
  cv::Mat image(256, 256, CV_8UC3, cv::Scalar::all(255));
  DrawText(spec, rng, &image);
  const int inked = cv::countNonZero(image.reshape(1) < 200);
  EXPECT_GT(inked, 500);
  EXPECT_LT(inked, 256 * 256 * 3 * 8 / 10);
}

TEST(DrawBooks, StaysWithinASmallPicture) {
  TextureSpec spec;
  spec.width_px = 20;
  spec.height_px = 30;
  Rng rng(1);
  cv::Mat image(30, 20, CV_8UC3, cv::Scalar::all(255));
  DrawBooks(spec, rng, &image);
  EXPECT_EQ(image.size(), cv::Size(20, 30));
}

TEST(RandomColor, IsAColour) {
  Rng rng(2);
  for (int i = 0; i < 100; ++i) EXPECT_LT(std::abs(RandomColor(rng)[0] - 125.0), 225.0);
}

}  // namespace
}  // namespace rovio_sfm::sim
