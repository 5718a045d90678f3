#include "rovio_sfm/recognition/largest_features.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace rovio_sfm {
namespace {

// A feature of each size, its number in place of what else it has.
std::shared_ptr<const FrameFeatures> FeaturesOfSizes(const std::vector<float>& sizes_px) {
  FrameFeatures features;
  features.descriptors.type = DescriptorType::kSift;
  features.descriptors.length = 2;
  for (const float size_px : sizes_px) {
    const auto number = static_cast<uint8_t>(features.keypoints.size());
    Keypoint keypoint;
    keypoint.x_px = number;
    keypoint.size_px = size_px;
    features.keypoints.push_back(keypoint);
    features.colors.push_back({number, 0, 0});
    features.descriptors.data.insert(features.descriptors.data.end(), {number, number});
  }
  return std::make_shared<FrameFeatures>(features);
}

TEST(LargestFeatures, KeepsTheirOrderAndAllThatBelongsToThem) {
  const auto largest = LargestFeatures(FeaturesOfSizes({3, 9, 1, 5}), 2);
  ASSERT_EQ(largest->keypoints.size(), 2u);
  EXPECT_EQ(largest->keypoints[0].x_px, 1.0f);
  EXPECT_EQ(largest->keypoints[1].x_px, 3.0f);
  EXPECT_EQ(largest->colors, (std::vector<Rgb>{{1, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(largest->descriptors.data, (std::vector<uint8_t>{1, 1, 3, 3}));
  EXPECT_EQ(largest->descriptors.type, DescriptorType::kSift);
}

TEST(LargestFeatures, TakesTheFirstOfEquallyLargeOnes) {
  const auto largest = LargestFeatures(FeaturesOfSizes({4, 7, 4, 4}), 3);
  EXPECT_EQ(largest->descriptors.data, (std::vector<uint8_t>{0, 0, 1, 1, 2, 2}));
}

TEST(LargestFeatures, KeepsAllWhereThereAreNoMore) {
  const auto features = FeaturesOfSizes({3, 9, 1});
  EXPECT_EQ(LargestFeatures(features, 3), features);
  EXPECT_TRUE(LargestFeatures(FeaturesOfSizes({}), 3)->keypoints.empty());
}

}  // namespace
}  // namespace rovio_sfm
