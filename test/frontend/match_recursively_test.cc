#include "rovio_sfm/frontend/match_recursively.h"

#include <gtest/gtest.h>

#include "frontend/moving_images.h"
#include "rovio_sfm/features/extract_features.h"

namespace rovio_sfm {
namespace {

std::shared_ptr<const FrameFeatures> FeaturesOf(const cv::Mat& image) {
  ExtractOptions options;
  options.max_features = 250;
  return std::make_shared<const FrameFeatures>(
      ExtractFeatures(image, MovingImages::TheCamera(), options));
}

class MatchRecursivelyTest : public testing::Test {
 protected:
  void SetUp() override {
    const MovingImages images;
    for (uint32_t i = 0; i < 3; ++i) recent_.push_back({i, FeaturesOf(images.At(6.0 * i))});
    keyframe_ = {3, FeaturesOf(images.At(18.0))};
  }

  std::vector<PairMatches> Match() const {
    return MatchRecursively(recent_, keyframe_, MovingImages::TheCamera(), {}, options_, 1);
  }

  // Replaces a recent keyframe by one that shows something else.
  void Spoil(size_t i) {
    cv::Mat foreign;
    cv::rotate(MovingImages().At(300), foreign, cv::ROTATE_180);
    recent_[i].features = FeaturesOf(foreign);
  }

  RecursionOptions options_;
  std::deque<RecentKeyframe> recent_;
  RecentKeyframe keyframe_;
};

TEST_F(MatchRecursivelyTest, GoesBackFromTheNearest) {
  const auto pairs = Match();
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].other_index, 2u);
  EXPECT_EQ(pairs[2].other_index, 0u);
  for (const PairMatches& pair : pairs) EXPECT_GE(pair.inliers.size(), 30u);
}

TEST_F(MatchRecursivelyTest, StopsAfterTauLFrames) {
  options_.max_frames = 2;
  EXPECT_EQ(Match().size(), 2u);
}

TEST_F(MatchRecursivelyTest, GoesBackThroughTheWholeWindow) {
  Spoil(2);
  Spoil(1);
  const auto pairs = Match();
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_GE(pairs[2].inliers.size(), 30u);
}

TEST_F(MatchRecursivelyTest, PassesOverAsManyMissesAsItMay) {
  options_.max_misses = 1;
  Spoil(2);
  auto pairs = Match();
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].verdict, PairVerdict::kFailed);
  EXPECT_TRUE(pairs[0].inliers.empty());
  EXPECT_GE(pairs[1].inliers.size(), 30u);
  Spoil(1);
  EXPECT_EQ(Match().size(), 2u);
}

TEST_F(MatchRecursivelyTest, IsDeterministic) {
  const auto a = Match(), b = Match();
  for (size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].inliers.size(), b[i].inliers.size());
    EXPECT_EQ(a[i].cam_from_other.translation, b[i].cam_from_other.translation);
  }
}

}  // namespace
}  // namespace rovio_sfm
