#include "rovio_sfm/matching/match_posed.h"

#include <gtest/gtest.h>

#include "matching/camera_pair.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// Points before two cameras side by side; feature i of a and of b show one point and have one
// descriptor.
CameraPair MakePair(size_t count) {
  CameraPair pair = SideBySide();
  Rng rng(3);
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x(rng.Uniform(-2, 2), rng.Uniform(-2, 2), rng.Uniform(4, 9));
    std::vector<uint8_t> descriptor(64);
    for (uint8_t& byte : descriptor) byte = static_cast<uint8_t>(rng.Uniform(0, 255));
    AddFeature(x, descriptor, &pair.a);
    AddFeature(pair.b_from_a * x, descriptor, &pair.b);
  }
  return pair;
}

std::vector<DepthRange> NoRanges(const CameraPair& pair) {
  return std::vector<DepthRange>(pair.b.keypoints.size());
}

TEST(MatchPosed, FindsWhatLooksAlikeInTheBand) {
  const CameraPair pair = MakePair(50);
  const PairMatches found =
      MatchPosed(7, pair.a, pair.b, pair.b_from_a, NoRanges(pair), kFocalPx, {});
  EXPECT_EQ(found.other_index, 7u);
  EXPECT_EQ(found.verdict, PairVerdict::kGeneral);
  ASSERT_EQ(found.inliers.size(), 50u);
  for (const FeatureMatch& match : found.inliers) EXPECT_EQ(match.a, match.b);
}

TEST(MatchPosed, DropsWhatThePosesForbid) {
  CameraPair pair = MakePair(50);
  pair.b.keypoints[4].x_normalized.y() += 3.0 * 2.0 / kFocalPx;  // off its line
  pair.b.keypoints[9].x_normalized.x() += 3.0;                   // behind the cameras
  const PairMatches found =
      MatchPosed(0, pair.a, pair.b, pair.b_from_a, NoRanges(pair), kFocalPx, {});
  EXPECT_EQ(found.counts.one_to_one, 50u);
  EXPECT_EQ(found.inliers.size(), 48u);
  for (const FeatureMatch& match : found.inliers) EXPECT_TRUE(match.b != 4 && match.b != 9);
}

TEST(MatchPosed, FindsNothingFromOnePlaceOrWithoutDescriptors) {
  CameraPair pair = MakePair(10);
  EXPECT_TRUE(MatchPosed(0, pair.a, pair.b, {}, NoRanges(pair), kFocalPx, {}).inliers.empty());
  pair.a.descriptors = {};
  EXPECT_TRUE(
      MatchPosed(0, pair.a, pair.b, pair.b_from_a, NoRanges(pair), kFocalPx, {}).inliers.empty());
}

}  // namespace
}  // namespace rovio_sfm
