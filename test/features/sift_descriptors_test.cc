#include "rovio_sfm/features/sift_descriptors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>

#include "features/test_images.h"
#include "rovio_sfm/features/sift_keypoints.h"

namespace rovio_sfm {
namespace {

// OpenCV packs octave (signed, -1 first) and layer into one number.
cv::KeyPoint FromOpenCv(cv::KeyPoint keypoint) {
  keypoint.class_id = (keypoint.octave >> 8) & 255;
  keypoint.octave = static_cast<int8_t>(keypoint.octave & 255) + 1;
  keypoint.pt -= cv::Point2f(0.25f, 0.25f);
  return keypoint;
}

struct OpenCvFeatures {
  std::vector<cv::KeyPoint> keypoints;
  cv::Mat descriptors;
};

OpenCvFeatures FeaturesOfOpenCv(const cv::Mat& grey) {
  OpenCvFeatures features;
  const auto sift = cv::SIFT::create(0, 3, 0.02, 10.0, 1.6);
  sift->detectAndCompute(grey, cv::noArray(), features.keypoints, features.descriptors);
  std::transform(features.keypoints.begin(), features.keypoints.end(), features.keypoints.begin(),
                 FromOpenCv);
  return features;
}

double AngleGap(float a, float b) { return std::abs(std::remainder(a - b, 360.0)); }

TEST(DescribeSift, DescribesAsOpenCvDoes) {
  const OpenCvFeatures theirs = FeaturesOfOpenCv(TexturedGrey(320, 240, 3));
  ASSERT_GT(theirs.keypoints.size(), 100u);
  const cv::Mat ours =
      DescribeSift(BuildSiftOctaves(TexturedGrey(320, 240, 3), true), theirs.keypoints);
  ASSERT_EQ(ours.size(), theirs.descriptors.size());
  for (int i = 0; i < ours.rows; ++i) {
    EXPECT_LT(cv::norm(ours.row(i), theirs.descriptors.row(i)), 15.0) << "of a length of 512";
  }
}

TEST(OrientSift, FindsADirectionThatOpenCvFinds) {
  const OpenCvFeatures theirs = FeaturesOfOpenCv(TexturedGrey(320, 240, 3));
  std::vector<cv::KeyPoint> ours = theirs.keypoints;
  OrientSift(BuildSiftOctaves(TexturedGrey(320, 240, 3), true), &ours);
  size_t num_equal = 0;
  for (const cv::KeyPoint& keypoint : ours) {
    num_equal += std::any_of(theirs.keypoints.begin(), theirs.keypoints.end(),
                             [&](const cv::KeyPoint& other) {
                               return other.pt == keypoint.pt && other.size == keypoint.size &&
                                      AngleGap(other.angle, keypoint.angle) < 1.0;
                             });
  }
  EXPECT_GE(num_equal, 0.99 * static_cast<double>(ours.size()));
}

TEST(DescribeSift, TurnsWithThePicture) {
  const cv::Mat grey = TexturedGrey(320, 240, 3);
  cv::Mat turned;
  cv::rotate(grey, turned, cv::ROTATE_90_CLOCKWISE);
  const auto octaves = BuildSiftOctaves(grey, false),
             octaves_turned = BuildSiftOctaves(turned, false);
  std::vector<cv::KeyPoint> keypoints(1);
  keypoints[0].pt = {150.0f, 100.0f};
  keypoints[0].size = 4.0f;
  keypoints[0].octave = 0;
  keypoints[0].class_id = 1;
  std::vector<cv::KeyPoint> keypoints_turned = keypoints;
  keypoints_turned[0].pt = {static_cast<float>(grey.rows - 1) - 100.0f, 150.0f};
  OrientSift(octaves, &keypoints);
  OrientSift(octaves_turned, &keypoints_turned);
  EXPECT_LT(AngleGap(keypoints[0].angle + 90.0f, keypoints_turned[0].angle), 1.0);
  EXPECT_LT(
      cv::norm(DescribeSift(octaves, keypoints), DescribeSift(octaves_turned, keypoints_turned)),
      20.0);
}

TEST(DescribeSift, OfNoneIsEmpty) {
  EXPECT_TRUE(DescribeSift(BuildSiftOctaves(TexturedGrey(320, 240, 3), false), {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
