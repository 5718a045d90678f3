#include "rovio_sfm/features/blur.h"

#include <gtest/gtest.h>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

TEST(SharpnessScore, FallsWithBlur) {
  cv::Mat grey, slightly, strongly;
  cv::cvtColor(TexturedImage(320, 240, 2), grey, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(grey, slightly, cv::Size(), 1.5);
  cv::GaussianBlur(grey, strongly, cv::Size(), 4.0);
  EXPECT_GT(SharpnessScore(grey), 1.3 * SharpnessScore(slightly));
  EXPECT_GT(SharpnessScore(slightly), 1.3 * SharpnessScore(strongly));
}

TEST(SharpnessScore, OfAPlainOrEmptyImageIsZero) {
  EXPECT_EQ(SharpnessScore(cv::Mat(20, 20, CV_8U, cv::Scalar(50))), 0.0);
  EXPECT_EQ(SharpnessScore(cv::Mat()), 0.0);
}

}  // namespace
}  // namespace rovio_sfm
