#include "rovio_sfm/frontend/match_recursively.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "frontend/moving_images.h"
#include "rovio_sfm/features/extract_features.h"
#include "rovio_sfm/tracks/track_builder.h"

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

  std::vector<PairMatches> Search() {
    const int as_before = std::exchange(options_.min_expected, 1'000'000);
    const auto pairs = Match();
    options_.min_expected = as_before;
    return pairs;
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

  // As the frontend does.
  void BuildTracks() {
    TrackBuilder builder{TrackOptions{}};
    std::deque<RecentKeyframe> before;
    for (RecentKeyframe& keyframe : recent_) {
      std::vector<Eigen::Vector2f> places;
      for (const Keypoint& k : keyframe.features->keypoints) places.emplace_back(k.x_px, k.y_px);
      const auto pairs =
          MatchRecursively(before, keyframe, MovingImages::TheCamera(), {}, options_, 1);
      keyframe.tracks = builder.Add(keyframe.index, places, pairs).tracks;
      before.push_back(keyframe);
    }
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

std::set<std::pair<uint32_t, uint32_t>> SetOf(const std::vector<FeatureMatch>& matches) {
  std::set<std::pair<uint32_t, uint32_t>> set;
  for (const FeatureMatch& match : matches) set.insert({match.a, match.b});
  return set;
}

TEST_F(MatchRecursivelyTest, FindsByTracksWhatASearchFinds) {
  BuildTracks();
  const auto searched = Search(), expected = Match();
  ASSERT_EQ(expected.size(), 3u);
  EXPECT_EQ(SetOf(expected[0].inliers), SetOf(searched[0].inliers));
  for (size_t i = 1; i < 3; ++i) {
    EXPECT_NE(expected[i].counts.ratio, searched[i].counts.ratio);  // no search
    const auto found = SetOf(expected[i].inliers), wanted = SetOf(searched[i].inliers);
    size_t num_common = 0;
    for (const auto& match : wanted) num_common += found.count(match);
    EXPECT_GT(5 * num_common, 4 * wanted.size());
    EXPECT_LT(
        expected[i].cam_from_other.rotation.angularDistance(searched[i].cam_from_other.rotation),
        0.003);
  }
}

TEST_F(MatchRecursivelyTest, SearchesWhereTracksAreWrong) {
  BuildTracks();
  const auto searched = Search();
  for (RecentKeyframe& keyframe : recent_) {
    if (keyframe.index % 2 == 0) std::reverse(keyframe.tracks.begin(), keyframe.tracks.end());
  }
  const auto pairs = Match();
  ASSERT_EQ(pairs.size(), searched.size());
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(SetOf(pairs[i].inliers), SetOf(searched[i].inliers));
    EXPECT_EQ(pairs[i].counts.ratio, searched[i].counts.ratio);
  }
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
