#include "rovio_sfm/features/extract_features.h"

#include <gtest/gtest.h>

#include <map>

#include "features/test_images.h"

namespace rovio_sfm {
namespace {

class ExtractFeaturesOfType : public testing::TestWithParam<DescriptorType> {
 protected:
  ExtractOptions Options() const {
    ExtractOptions options;
    options.type = GetParam();
    options.max_features = 300;
    return options;
  }
};

TEST_P(ExtractFeaturesOfType, GivesVectorsOfEqualLengthWithinTheBudget) {
  const cv::Mat image = TexturedImage(320, 240, 3);
  const FrameFeatures features = ExtractFeatures(image, TestCamera(320, 240), Options());
  EXPECT_GT(features.keypoints.size(), 100u);
  EXPECT_LE(features.keypoints.size(), 300u);
  EXPECT_EQ(features.colors.size(), features.keypoints.size());
  EXPECT_EQ(features.descriptors.Count(), features.keypoints.size());
  EXPECT_EQ(features.descriptors.type, GetParam());
}

TEST_P(ExtractFeaturesOfType, IsDeterministic) {
  const cv::Mat image = TexturedImage(320, 240, 3);
  const FrameFeatures a = ExtractFeatures(image, TestCamera(320, 240), Options());
  const FrameFeatures b = ExtractFeatures(image, TestCamera(320, 240), Options());
  ASSERT_EQ(a.keypoints.size(), b.keypoints.size());
  EXPECT_EQ(a.descriptors.data, b.descriptors.data);
  EXPECT_EQ(a.colors, b.colors);
}

TEST_P(ExtractFeaturesOfType, UndistortsEachKeypoint) {
  Camera camera = TestCamera(320, 240);
  camera.k1 = 0.2;
  const FrameFeatures features = ExtractFeatures(TexturedImage(320, 240, 3), camera, Options());
  for (const Keypoint& keypoint : features.keypoints) {
    const Eigen::Vector2d x_px = PixelFromNormalized(camera, keypoint.x_normalized);
    EXPECT_LT((x_px - Eigen::Vector2d(keypoint.x_px, keypoint.y_px)).norm(), 1e-3);
  }
}

TEST_P(ExtractFeaturesOfType, FindsNothingInAPlainImage) {
  const cv::Mat plain(240, 320, CV_8UC3, cv::Scalar::all(90));
  const FrameFeatures features = ExtractFeatures(plain, TestCamera(320, 240), Options());
  EXPECT_TRUE(features.keypoints.empty());
  EXPECT_EQ(features.descriptors.Count(), 0u);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, ExtractFeaturesOfType,
                         testing::Values(DescriptorType::kSift, DescriptorType::kOrb,
                                         DescriptorType::kAkaze, DescriptorType::kSurf),
                         [](const auto& instance) { return NameOfDescriptorType(instance.param); });

TEST(ExtractFeatures, LocatesABlobWithoutBias) {
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar::all(60));
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double r2 = (x - 160.0) * (x - 160.0) + (y - 120.0) * (y - 120.0);
      image.at<cv::Vec3b>(y, x) = cv::Vec3b::all(static_cast<uint8_t>(60 + 150 * exp(-r2 / 50.0)));
    }
  }
  const FrameFeatures features = ExtractFeatures(image, TestCamera(320, 240), ExtractOptions{});
  ASSERT_EQ(features.keypoints.size(), 1u);
  EXPECT_NEAR(features.keypoints[0].x_px, 160.0, 0.05);
  EXPECT_NEAR(features.keypoints[0].y_px, 120.0, 0.05);
}

TEST(ExtractFeatures, DropsWhatCannotBeUndistorted) {
  Camera camera = TestCamera(320, 240);
  camera.k1 = -0.9;  // folds back inside the image
  const cv::Mat image = TexturedImage(320, 240, 3);
  const size_t all = ExtractFeatures(image, TestCamera(320, 240), {}).keypoints.size();
  const FrameFeatures features = ExtractFeatures(image, camera, {});
  EXPECT_LT(features.keypoints.size(), all);
  EXPECT_EQ(features.descriptors.Count(), features.keypoints.size());
}

TEST(ExtractFeatures, WithoutUpsamplingHasNoTinyFeatures) {
  ExtractOptions options;
  options.upsample = false;
  for (const Keypoint& k :
       ExtractFeatures(TexturedImage(320, 240, 3), TestCamera(320, 240), options).keypoints) {
    EXPECT_GT(k.size_px, 3.2f);
  }
}

}  // namespace
}  // namespace rovio_sfm
