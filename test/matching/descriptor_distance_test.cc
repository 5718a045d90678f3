#include "rovio_sfm/matching/descriptor_distance.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(DescriptorDistance, IsTheLengthOfTheDifference) {
  Descriptors a{DescriptorType::kSift, DescriptorMetric::kL2, 2, {9, 9, 1, 2}};
  Descriptors b{DescriptorType::kSift, DescriptorMetric::kL2, 2, {4, 6}};
  EXPECT_FLOAT_EQ(DescriptorDistance(a, 1, b, 0), 5.0f);
}

TEST(DescriptorDistance, CountsBitsOfBinaryOnes) {
  Descriptors a{DescriptorType::kOrb, DescriptorMetric::kHamming, 2, {0x0f, 0x01}};
  Descriptors b{DescriptorType::kOrb, DescriptorMetric::kHamming, 2, {0x00, 0x03}};
  EXPECT_FLOAT_EQ(DescriptorDistance(a, 0, b, 0), 5.0f);
}

}  // namespace
}  // namespace rovio_sfm
