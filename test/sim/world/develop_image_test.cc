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

DevelopOptions BayerWithoutNoise() {
  DevelopOptions options = WithoutNoise();
  options.sensor = Sensor::kBayer;
  return options;
}

TEST(DevelopImage, BayerSensorKeepsColorsApart) {
  const cv::Mat red(120, 160, CV_32FC3, cv::Scalar(0.5, 0.1, 0.02));  // RGB
  const cv::Mat picture = DevelopImage(red, 1.0, BayerWithoutNoise(), 1);
  const cv::Mat plain = DevelopImage(red, 1.0, WithoutNoise(), 1);
  EXPECT_LE(cv::norm(picture, plain, cv::NORM_INF), 1.0);
}

TEST(DevelopImage, LensBlursAnEdge) {
  cv::Mat edge(120, 160, CV_32FC3, cv::Scalar::all(0.05));
  edge.colRange(80, 160).setTo(cv::Scalar::all(0.5));
  DevelopOptions options = WithoutNoise();
  const auto step = [&] {
    const cv::Mat picture = DevelopImage(edge, 1.0, options, 1);
    return picture.at<cv::Vec3b>(60, 80)[0] - picture.at<cv::Vec3b>(60, 79)[0];
  };
  const int razor = step();
  options.lens_sigma_px = 0.8;
  EXPECT_LT(step(), 0.6 * razor);
  EXPECT_GT(step(), 0.2 * razor);
}

TEST(DevelopImage, MeteringEvensOutPartOfTheLight) {
  DevelopOptions options = WithoutNoise();
  const auto level = [&](double light) {
    const cv::Mat wall(120, 160, CV_32FC3, cv::Scalar::all(light));
    return int{DevelopImage(wall, 1.0, options, 1).at<cv::Vec3b>(60, 80)[0]};
  };
  const int unmetered = level(0.36) - level(0.09);
  options.metering = 0.6;
  EXPECT_LT(level(0.36) - level(0.09), 0.6 * unmetered);
  EXPECT_GT(level(0.36) - level(0.09), 0.2 * unmetered);
  options.metering = 1.0;
  EXPECT_NEAR(level(0.36), level(0.09), 1);
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
