#include "rovio_sfm/features/surf_features.h"

#include <gtest/gtest.h>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

TEST(ExtractSurf, DescribesEachKeypointWithSixtyFourBytes) {
  cv::Mat grey;
  cv::cvtColor(TexturedImage(320, 240, 5), grey, cv::COLOR_BGR2GRAY);
  const SurfFeatures features = ExtractSurf(grey, 8.0, {});
  EXPECT_GT(features.keypoints.size(), 60u);
  EXPECT_EQ(features.descriptors.length, 64u);
  EXPECT_EQ(features.descriptors.Count(), features.keypoints.size());
  for (const cv::KeyPoint& keypoint : features.keypoints) {
    EXPECT_GE(keypoint.angle, 0.0f);
    EXPECT_LT(keypoint.angle, 360.0f);
  }
}

}  // namespace
}  // namespace rovio_sfm
