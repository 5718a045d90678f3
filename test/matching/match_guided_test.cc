#include "rovio_sfm/matching/match_guided.h"

#include <gtest/gtest.h>

#include "matching/camera_pair.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// Points before two cameras side by side; feature i of a shows the same point as feature i of b and
// their descriptors are alike.
CameraPair MakePair(size_t count) {
  CameraPair pair = SideBySide();
  Rng rng(3);
  for (size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x(rng.Uniform(-2, 2), rng.Uniform(-2, 2), rng.Uniform(4, 9));
    AddFeature(x, static_cast<uint8_t>(5 * i), &pair.a);
    AddFeature(pair.b_from_a * x, static_cast<uint8_t>(5 * i + 1), &pair.b);
  }
  return pair;
}

const std::vector<FeatureMatch> kKnown = {{0, 0, 8.0f, 0.5f}};

TEST(MatchGuided, FindsTheRestAlongTheBand) {
  const CameraPair pair = MakePair(40);
  const auto found = MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {});
  ASSERT_EQ(found.size(), 39u);
  for (const FeatureMatch& match : found) EXPECT_EQ(match.a, match.b);
}

TEST(MatchGuided, NeverTouchesKnownFeatures) {
  const CameraPair pair = MakePair(40);
  for (const FeatureMatch& match :
       MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {})) {
    EXPECT_NE(match.a, 0u);
    EXPECT_NE(match.b, 0u);
  }
}

TEST(MatchGuided, RefusesAlikeFeaturesOffTheBand) {
  CameraPair pair = MakePair(40);
  pair.b.keypoints[7].x_normalized.y() += 5.0 / kFocalPx;
  for (const FeatureMatch& match :
       MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {})) {
    EXPECT_FALSE(match.a == 7 && match.b == 7);
  }
}

TEST(MatchGuided, RefusesPointsBehindTheCameras) {
  CameraPair pair = MakePair(2);
  pair.b.keypoints[1].x_normalized.x() = pair.a.keypoints[1].x_normalized.x() + 0.3;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {}).empty());
}

TEST(MatchGuided, RefusesUnlikeDescriptors) {
  CameraPair pair = MakePair(2);
  for (size_t i = 64; i < 128; ++i) pair.b.descriptors.data[i] = 200;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {}).empty());
}

TEST(MatchGuided, IsEmptyWithoutKnownMatchesOrTranslation) {
  const CameraPair pair = MakePair(10);
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, {}, kFocalPx, {}).empty());
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, Rigid3{}, kKnown, kFocalPx, {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
