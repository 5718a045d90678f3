#include "rovio_sfm/features/root_sift.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

TEST(RootSiftFromSift, IsTheRootedL1NormTimes512) {
  cv::Mat sift(1, 128, CV_32F, cv::Scalar(0));
  sift.at<float>(0, 0) = 100.0f;
  sift.at<float>(0, 5) = 300.0f;
  for (int i = 10; i < 70; ++i) sift.at<float>(0, i) = 20.0f;
  const Descriptors root = RootSiftFromSift(sift);
  ASSERT_EQ(root.Count(), 1u);
  EXPECT_EQ(root.Row(0)[0], std::lround(512.0 * std::sqrt(100.0 / 1600.0)));
  EXPECT_EQ(root.Row(0)[5], std::lround(512.0 * std::sqrt(300.0 / 1600.0)));
}

TEST(RootSiftFromSift, ClampsAndTakesZeros) {
  cv::Mat sift(2, 128, CV_32F, cv::Scalar(0));
  sift.at<float>(1, 7) = 9.0f;
  const Descriptors root = RootSiftFromSift(sift);
  EXPECT_EQ(root.Row(0)[7], 0);
  EXPECT_EQ(root.Row(1)[7], 255);
}

TEST(RootSiftFromSift, OfNoneKeepsTypeAndLength) {
  const Descriptors root = RootSiftFromSift(cv::Mat());
  EXPECT_EQ(root.Count(), 0u);
  EXPECT_EQ(root.length, 128u);
  EXPECT_EQ(root.type, DescriptorType::kSift);
}

}  // namespace
}  // namespace rovio_sfm
