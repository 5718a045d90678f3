#include "rovio_sfm/matching/match_in_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "matching/camera_pair.h"

namespace rovio_sfm {
namespace {

const std::vector<FeatureMatch> kKnown = {{0, 0, 8.0f, 0.5f}};

// Two cameras side by side see a known point and one at 5 units; in a another feature that looks
// more like it lies on the same epipolar line, where a point at 2 units would.
class MatchInRangeTest : public testing::Test {
 protected:
  MatchInRangeTest() {
    const Eigen::Vector3d known(1.0, 1.0, 4.0), far(0.0, 0.0, 5.0);
    AddFeature(known, 0, &a_);
    AddFeature(far, 101, &a_);
    AddFeature(Inverse(b_from_a_) * Eigen::Vector3d(0.4 * (b_from_a_ * far)), 100, &a_);
    AddFeature(b_from_a_ * known, 0, &b_);
    AddFeature(b_from_a_ * far, 100, &b_);
  }

  std::vector<FeatureMatch> Match(const DepthRange& range) const {
    return MatchInRange(a_, b_, b_from_a_, {{}, range}, kKnown, kFocalPx, {});
  }

  CameraPair pair_ = SideBySide();
  FrameFeatures &a_ = pair_.a, &b_ = pair_.b;
  Rigid3& b_from_a_ = pair_.b_from_a;
};

TEST_F(MatchInRangeTest, FindsWhatLiesInTheRange) {
  const auto far = Match({4.5, 5.5}), near = Match({1.8, 2.2});
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].a, 1u);
  EXPECT_EQ(far[0].b, 1u);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].a, 2u);
}

TEST_F(MatchInRangeTest, FindsNothingElsewhere) {
  EXPECT_TRUE(Match({2.5, 4.0}).empty());
  EXPECT_TRUE(Match({}).empty());
  b_from_a_.translation.y() = 0.1;  // the line lies elsewhere
  EXPECT_TRUE(Match({4.5, 5.5}).empty());
}

TEST_F(MatchInRangeTest, RefusesWhatLooksOtherThanTheKnownOnes) {
  for (size_t i = 64; i < 128; ++i) a_.descriptors.data[i] = 120;
  EXPECT_TRUE(Match({4.5, 5.5}).empty());
}

// A sample of every feature: what lies off the stretch speaks too.
TEST_F(MatchInRangeTest, RefusesWhatLooksNoMoreAlikeThanASampleFromElsewhere) {
  AddFeature({3.0, 1.0, 5.0}, 102, &a_);  // 16 from the second of b, its partner 8
  const auto count = [this](float max_sample_ratio) {
    RangeMatchOptions options;
    options.sample_step = 1;
    options.max_sample_ratio = max_sample_ratio;
    return MatchInRange(a_, b_, b_from_a_, {{}, {4.5, 5.5}}, kKnown, kFocalPx, options).size();
  };
  EXPECT_EQ(Match({4.5, 5.5}).size(), 1u);
  EXPECT_EQ(count(0.51f), 0u);  // the twin at a nearer depth is no more than as like
  a_.descriptors.data[2 * 64] = 0, a_.descriptors.data[2 * 64 + 1] = 0;  // now it is not
  EXPECT_EQ(count(0.51f), 1u);
  EXPECT_EQ(count(0.49f), 0u);
}

// There a point may have been detected twice.
TEST_F(MatchInRangeTest, LeavesWhatLiesCloseToTheStretchOutOfTheSample) {
  a_.descriptors.data[2 * 64] = 0;  // no twin at a nearer depth
  AddFeature({0.0, 0.0, 5.0}, 100, &a_);
  RangeMatchOptions options;
  options.sample_step = 1;
  for (const auto& [off_px, count] : {std::pair(5.0, 1u), std::pair(12.0, 0u)}) {
    a_.keypoints.back().x_normalized.y() = off_px / kFocalPx;
    EXPECT_EQ(MatchInRange(a_, b_, b_from_a_, {{}, {4.5, 5.5}}, kKnown, kFocalPx, options).size(),
              count);
  }
}

// Whichever way the line runs: each of many points that look alike in pairs has one partner in its
// range.
TEST(MatchInRange, FindsEveryPointOfManyForAnyDirection) {
  constexpr uint32_t kNumPoints = 300;
  for (const double angle : {0.0, 0.6, 1.5707963, 2.8}) {
    auto [a, b, b_from_a] = SideBySide();
    b_from_a.translation = {std::cos(angle), std::sin(angle), 0.1};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.8, 0.8), depth(4.0, 9.0);
    std::vector<DepthRange> ranges;
    for (uint32_t i = 0; i < kNumPoints; ++i) {
      const Eigen::Vector3d x = depth(random) * Eigen::Vector3d(place(random), place(random), 1.0);
      AddFeature(x, static_cast<uint8_t>(i % 150), &a);
      AddFeature(b_from_a * x, static_cast<uint8_t>(i % 150), &b);
      const double z = (b_from_a * x).z();
      ranges.push_back({z / 1.01, z * 1.01});
    }
    const auto found = MatchInRange(a, b, b_from_a, ranges, kKnown, kFocalPx, {});
    EXPECT_GT(found.size(), kNumPoints - 15);  // some twins lie in one range
    for (const FeatureMatch& match : found) EXPECT_EQ(match.a, match.b);
  }
}

}  // namespace
}  // namespace rovio_sfm
