#include "rovio_sfm/matching/match_pair.h"

#include <gtest/gtest.h>

#include "frontend/moving_images.h"
#include "rovio_sfm/features/extract_features.h"

namespace rovio_sfm {
namespace {

FrameFeatures FeaturesOf(const cv::Mat& image, DescriptorType type) {
  ExtractOptions options;
  options.max_features = 250;
  options.type = type;
  return ExtractFeatures(image, MovingImages::TheCamera(), options);
}

TEST(MatchPair, FindsASidewaysMotionAndCountsEachFilter) {
  const MovingImages images;
  const FrameFeatures a = FeaturesOf(images.At(0), DescriptorType::kSift);
  const FrameFeatures b = FeaturesOf(images.At(10), DescriptorType::kSift);
  Rng rng(1);
  const PairMatches pair = MatchPair(7, a, b, MovingImages::TheCamera(), {}, rng);
  EXPECT_EQ(pair.other_index, 7u);
  ASSERT_NE(pair.verdict, PairVerdict::kFailed);
  EXPECT_EQ(pair.counts.features, b.keypoints.size());
  EXPECT_EQ(pair.counts.guided, pair.inliers.size());
  for (const FeatureMatch& match : pair.inliers) {
    EXPECT_LT(match.a, a.keypoints.size());
    EXPECT_LT(match.b, b.keypoints.size());
  }
}

TEST(MatchPair, GivesAFailedPairForForeignDescriptors) {
  const MovingImages images;
  Rng rng(1);
  const PairMatches pair = MatchPair(0, FeaturesOf(images.At(0), DescriptorType::kOrb),
                                     FeaturesOf(images.At(10), DescriptorType::kSift),
                                     MovingImages::TheCamera(), {}, rng);
  EXPECT_EQ(pair.verdict, PairVerdict::kFailed);
  EXPECT_TRUE(pair.inliers.empty());
}

// Of what is expected, geometry takes what is right.
TEST(MatchExpected, KeepsWhatGeometryAllowsAndFindsMore) {
  const MovingImages images;
  const FrameFeatures a = FeaturesOf(images.At(0), DescriptorType::kSift);
  const FrameFeatures b = FeaturesOf(images.At(10), DescriptorType::kSift);
  Rng rng(1);
  const auto found = MatchPair(7, a, b, MovingImages::TheCamera(), {}, rng).inliers;
  std::vector<FeatureMatch> expected;
  for (size_t i = 2; i < found.size(); i += 2) expected.push_back(found[i]);
  const uint32_t wrong_a = found.front().a, wrong_b = found.back().b;
  expected.push_back({wrong_a, wrong_b, 0.0f, 0.1f});
  const PairMatches pair = MatchExpected(7, a, b, expected, MovingImages::TheCamera(), {}, rng);
  ASSERT_EQ(pair.verdict, PairVerdict::kGeneral);
  EXPECT_EQ(pair.counts.ratio, expected.size());
  EXPECT_GT(pair.counts.guided, pair.counts.ransac + found.size() / 4);
  for (const FeatureMatch& match : pair.inliers) {
    EXPECT_FALSE(match.a == wrong_a && match.b == wrong_b);
  }
}

TEST(MatchExpected, FailsForForeignDescriptors) {
  const MovingImages images;
  Rng rng(1);
  const PairMatches pair =
      MatchExpected(0, FeaturesOf(images.At(0), DescriptorType::kOrb),
                    FeaturesOf(images.At(10), DescriptorType::kSift), std::vector<FeatureMatch>(50),
                    MovingImages::TheCamera(), {}, rng);
  EXPECT_EQ(pair.verdict, PairVerdict::kFailed);
}

TEST(MatchPair, FailsWithoutFeatures) {
  Rng rng(1);
  const PairMatches pair = MatchPair(0, {}, {}, MovingImages::TheCamera(), {}, rng);
  EXPECT_EQ(pair.verdict, PairVerdict::kFailed);
}

}  // namespace
}  // namespace rovio_sfm
