#include "rovio_sfm/sim/world/develop_image.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace rovio_sfm::sim {
namespace {

const cv::Mat& GreyWall() {
  static const cv::Mat wall(120, 160, CV_32FC3, cv::Scalar::all(0.2));
  return wall;
}

DevelopOptions WithoutNoise() {
  DevelopOptions options;
  options.noise_sigma = 0.0;
  options.vignetting = 0.0;
  return options;
}

TEST(DevelopImage, FollowsTheSrgbCurve) {
  const cv::Mat picture = DevelopImage(GreyWall(), 1.0, WithoutNoise(), 1);
  EXPECT_NEAR(picture.at<cv::Vec3b>(60, 80)[0], 124, 1);  // 255 * sRGB(0.2)
}

TEST(DevelopImage, DoublesTheLightWithOneStop) {
  const cv::Mat once = DevelopImage(GreyWall(), 2.0, WithoutNoise(), 1);
  const cv::Mat bright(120, 160, CV_32FC3, cv::Scalar::all(0.4));
  EXPECT_EQ(cv::norm(once, DevelopImage(bright, 1.0, WithoutNoise(), 1), cv::NORM_INF), 0.0);
}

TEST(DevelopImage, DarkensTheCorners) {
  DevelopOptions options = WithoutNoise();
  options.vignetting = 0.5;
  const cv::Mat picture = DevelopImage(GreyWall(), 1.0, options, 1);
  EXPECT_LT(picture.at<cv::Vec3b>(0, 0)[1], picture.at<cv::Vec3b>(60, 80)[1] - 20);
}

TEST(DevelopImage, NoiseDependsOnTheSeedAlone) {
  const cv::Mat a = DevelopImage(GreyWall(), 1.0, {}, 1), b = DevelopImage(GreyWall(), 1.0, {}, 1);
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(a, DevelopImage(GreyWall(), 1.0, {}, 2), cv::NORM_INF), 5.0);
}

TEST(EncodeJpeg, StaysBelowTheRobotsBuffer) {
  cv::Mat noise(480, 640, CV_8UC3);
  cv::RNG rng(1);
  rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
  DevelopOptions options;
  options.max_bytes = 120000;
  const std::vector<uint8_t> jpeg = EncodeJpeg(noise, options);
  EXPECT_LE(jpeg.size(), options.max_bytes);
  EXPECT_EQ(cv::imdecode(jpeg, cv::IMREAD_COLOR).size(), cv::Size(640, 480));
}

TEST(DevelopOptions, NamesTheBadField) {
  DevelopOptions options;
  options.jpeg_quality = 0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("jpeg_quality"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
