#include "rovio_sfm/features/sift_octaves.h"

#include <gtest/gtest.h>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

TEST(BuildSiftOctaves, HalvesFromTheDoubledPictureOn) {
  const auto octaves = BuildSiftOctaves(TexturedGrey(320, 240, 3), true);
  ASSERT_EQ(octaves.size(), 6u);  // the last has 20 x 15 pixels
  for (size_t i = 0; i < octaves.size(); ++i) {
    EXPECT_EQ(octaves[i].images.size(), 6u);
    EXPECT_EQ(octaves[i].images.back().cols, 640 >> i);
    EXPECT_FLOAT_EQ(octaves[i].pixel_px, 0.5f * static_cast<float>(1 << i));
    EXPECT_FLOAT_EQ(octaves[i].origin_px, -0.25f);
  }
}

TEST(BuildSiftOctaves, BeginsWithThePictureItself) {
  const auto octaves = BuildSiftOctaves(TexturedGrey(320, 240, 3), false);
  ASSERT_EQ(octaves.size(), 5u);
  EXPECT_EQ(octaves[0].images[0].size(), cv::Size(320, 240));
  EXPECT_FLOAT_EQ(octaves[0].pixel_px, 1.0f);
  EXPECT_FLOAT_EQ(octaves[0].origin_px, 0.0f);
}

TEST(BuildSiftOctaves, BlursByTheStatedSigma) {
  cv::Mat point(129, 129, CV_8U, cv::Scalar(0));
  point.at<uint8_t>(64, 64) = 255;
  const auto octaves = BuildSiftOctaves(point, false);
  for (const int i : {0, 3, 5}) {
    const double added = std::pow(kSiftSigma * std::exp2(i / 3.0), 2) - 0.25;
    const double peak = 255.0 / (2.0 * CV_PI * added);
    EXPECT_NEAR(octaves[0].images[static_cast<size_t>(i)].at<float>(64, 64), peak, 0.03 * peak);
  }
}

TEST(BuildSiftOctaves, OfASpeckAreNone) {
  EXPECT_TRUE(BuildSiftOctaves(cv::Mat(8, 10, CV_8U, cv::Scalar(7)), false).empty());
}

}  // namespace
}  // namespace rovio_sfm
