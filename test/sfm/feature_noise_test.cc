#include "rovio_sfm/sfm/feature_noise.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

Keypoint OfSize(float size_px) {
  Keypoint keypoint;
  keypoint.size_px = size_px;
  return keypoint;
}

TEST(FeatureNoise, GrowsWithTheSizeOfLargeFeaturesAlone) {
  const FeatureNoise noise{2.0, 6.0, 0.5};
  EXPECT_DOUBLE_EQ(SigmaOf(OfSize(1.0f), 100.0, noise), 0.02);
  EXPECT_DOUBLE_EQ(SigmaOf(OfSize(6.0f), 100.0, noise), 0.02);
  EXPECT_DOUBLE_EQ(SigmaOf(OfSize(24.0f), 100.0, noise), 0.04);
}

}  // namespace
}  // namespace rovio_sfm
