#include "rovio_sfm/frontend/draw_matches.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

FrameFeatures TwoFeatures(float x_px) {
  FrameFeatures features;
  for (const float y_px : {10.0f, 30.0f}) {
    Keypoint keypoint;
    keypoint.x_px = x_px;
    keypoint.y_px = y_px;
    features.keypoints.push_back(keypoint);
  }
  features.descriptors.type = DescriptorType::kSift;
  features.descriptors.length = 128;
  features.descriptors.data.assign(256, 0);
  features.descriptors.data[0] = 255;
  features.descriptors.data[200] = 255;
  return features;
}

bool IsGreen(const cv::Vec3b& bgr) { return bgr[1] > 150 && bgr[0] < 150 && bgr[2] < 150; }

TEST(DrawMatches, JoinsInliersByAGreenLine) {
  const cv::Mat black(48, 64, CV_8UC3, cv::Scalar(0, 0, 0));
  PairMatches pair;
  pair.inliers = {{0, 0}};
  const cv::Mat image =
      DrawMatches(black, TwoFeatures(20.0f), black, TwoFeatures(40.0f), pair, PairOptions());
  ASSERT_EQ(image.size(), cv::Size(128, 48));
  EXPECT_TRUE(IsGreen(image.at<cv::Vec3b>(10, 60)));
  EXPECT_FALSE(IsGreen(image.at<cv::Vec3b>(30, 60)));
}

TEST(DrawMatches, KeypointsStandOutWhereTheyMatched) {
  const cv::Mat black(48, 64, CV_8UC3, cv::Scalar(0, 0, 0));
  FrameEvent event;
  event.features = std::make_shared<FrameFeatures>(TwoFeatures(20.0f));
  event.pairs.resize(1);
  event.pairs[0].inliers = {{0, 1}};
  const cv::Mat image = DrawKeypoints(black, event);
  EXPECT_FALSE(IsGreen(image.at<cv::Vec3b>(8, 20)));
  EXPECT_TRUE(IsGreen(image.at<cv::Vec3b>(28, 20)));
}

}  // namespace
}  // namespace rovio_sfm
