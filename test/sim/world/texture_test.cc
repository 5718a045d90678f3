#include "rovio_sfm/sim/world/texture.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(Texture, GivesTheColourOfATexelInLinearLight) {
  cv::Mat rgb(16, 16, CV_8UC3, cv::Scalar(255, 0, 0));
  const Texture texture(rgb, 0.01);
  const Eigen::Vector3f color = texture.Sample(8.0f, 8.0f, 1.0f, 0.0f);
  EXPECT_FLOAT_EQ(color.x(), 1.0f);
  EXPECT_FLOAT_EQ(color.y(), 0.0f);
}

TEST(Texture, ClampsAtTheBorder) {
  cv::Mat rgb(16, 16, CV_8UC3, cv::Scalar(0, 255, 0));
  const Texture texture(rgb, 0.01);
  EXPECT_FLOAT_EQ(texture.Sample(-50.0f, 500.0f, 1.0f, 0.0f).y(), 1.0f);
}

TEST(Texture, SmoothsOverAWideFootprint) {
  cv::Mat rgb(64, 64, CV_8UC3, cv::Scalar::all(0));
  for (int row = 0; row < 64; ++row) {
    for (int col = row % 2; col < 64; col += 2) rgb.at<cv::Vec3b>(row, col) = {255, 255, 255};
  }
  const Texture texture(rgb, 0.01);
  EXPECT_NEAR(texture.Sample(31.5f, 31.5f, 1.0f, 0.0f).x(), 1.0f, 1e-4f);
  const float wide = texture.Sample(31.5f, 31.5f, 8.0f, 0.0f).x();
  EXPECT_GT(wide, 0.1f);
  EXPECT_LT(wide, 0.5f);
}

TEST(Texture, TakesTheCoarserLevelByChance) {
  cv::Mat rgb(64, 64, CV_8UC3, cv::Scalar::all(0));
  for (int row = 0; row < 64; ++row) {
    for (int col = row % 2; col < 64; col += 2) rgb.at<cv::Vec3b>(row, col) = {255, 255, 255};
  }
  const Texture texture(rgb, 0.01);
  EXPECT_GT(texture.Sample(31.5f, 31.5f, 1.41f, 0.1f).x(), 0.99f);
  EXPECT_LT(texture.Sample(31.5f, 31.5f, 1.41f, 0.9f).x(), 0.5f);
}

}  // namespace
}  // namespace rovio_sfm::sim
