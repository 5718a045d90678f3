#include "rovio_sfm/matching/match_guided.h"

#include <gtest/gtest.h>

#include "matching/camera_pair.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// Points before two cameras side by side; feature i of a shows the same point as feature i of b and
// their descriptors are alike. The first is the nearest, the second the farthest.
CameraPair MakePair(size_t count) {
  CameraPair pair = SideBySide();
  Rng rng(3);
  for (size_t i = 0; i < count; ++i) {
    const double depth = i == 0 ? 4.0 : i == 1 ? 9.0 : rng.Uniform(4, 9);
    const Eigen::Vector3d x(rng.Uniform(-2, 2), rng.Uniform(-2, 2), depth);
    AddFeature(x, static_cast<uint8_t>(5 * i), &pair.a);
    AddFeature(pair.b_from_a * x, static_cast<uint8_t>(5 * i + 1), &pair.b);
  }
  return pair;
}

const std::vector<FeatureMatch> kKnown = {{0, 0, 8.0f, 0.5f}, {1, 1, 8.0f, 0.5f}};

TEST(MatchGuided, FindsTheRestAlongTheBand) {
  const CameraPair pair = MakePair(40);
  const auto found = MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {});
  ASSERT_EQ(found.size(), 38u);
  for (const FeatureMatch& match : found) EXPECT_EQ(match.a, match.b);
}

TEST(MatchGuided, NeverTouchesKnownFeatures) {
  const CameraPair pair = MakePair(40);
  for (const FeatureMatch& match :
       MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {})) {
    EXPECT_GT(match.a, 1u);
    EXPECT_GT(match.b, 1u);
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
  CameraPair pair = MakePair(3);
  pair.b.keypoints[2].x_normalized.x() = pair.a.keypoints[2].x_normalized.x() + 0.3;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {}).empty());
}

// A wall that shows one thing four times in a row: without the depths round it each is as like its
// twins on the epipolar line.
TEST(MatchGuided, TellsTwinsApartByTheDepthsRoundThem) {
  CameraPair pair = SideBySide();
  std::vector<FeatureMatch> known;
  const auto add = [&pair](double x, double y, uint8_t value) {
    const Eigen::Vector3d on_wall(x, y, 8.0);
    AddFeature(on_wall, value, &pair.a);
    AddFeature(pair.b_from_a * on_wall, static_cast<uint8_t>(value + 1), &pair.b);
  };
  for (uint32_t i = 0; i < 20; ++i) {
    add(0.2 * i, 0.1 * (i % 3), static_cast<uint8_t>(100 + i));
    known.push_back({i, i, 20.0f, 0.5f});
  }
  for (int i = 0; i < 4; ++i) add(0.9 * i, 0.05, 7);
  GuidedOptions options;
  options.range.sample_step = 0;  // it would hold twins
  const auto found = MatchGuided(pair.a, pair.b, pair.b_from_a, known, kFocalPx, options);
  ASSERT_EQ(found.size(), 4u);
  for (const FeatureMatch& match : found) EXPECT_EQ(match.a, match.b);
  GuidedOptions anywhere = options;
  anywhere.max_depth_ratio = 100.0;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, known, kFocalPx, anywhere).empty());
}

// A known match whose rays are parallel, or cross behind the cameras, lies far away.
TEST(MatchGuided, TakesKnownMatchesWithoutParallaxAsFar) {
  CameraPair pair = SideBySide();
  for (const double x : {0.0, 0.1, 0.2}) {
    AddFeature(Eigen::Vector3d(x, 0.1, 1.0), 50, &pair.a);
    AddFeature(Eigen::Vector3d(x + 1e-4, 0.1, 1.0), 50, &pair.b);
  }
  AddFeature(Eigen::Vector3d(0.05, 0.1, 1.0), 90, &pair.a);
  AddFeature(Eigen::Vector3d(0.05, 0.1, 1.0), 90, &pair.b);
  const std::vector<FeatureMatch> known = {
      {0, 0, 8.0f, 0.5f}, {1, 1, 8.0f, 0.5f}, {2, 2, 8.0f, 0.5f}};
  const auto found = MatchGuided(pair.a, pair.b, pair.b_from_a, known, kFocalPx, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].a, 3u);
  EXPECT_EQ(found[0].b, 3u);
}

TEST(MatchGuided, RefusesUnlikeDescriptors) {
  CameraPair pair = MakePair(3);
  for (size_t i = 128; i < 192; ++i) pair.b.descriptors.data[i] = 200;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, kKnown, kFocalPx, {}).empty());
}

TEST(MatchGuided, AllowsMoreWhereFewMatchesAreKnown) {
  CameraPair pair = MakePair(3);
  const std::vector<FeatureMatch> known = {{0, 0, 100.0f, 0.5f}, {1, 1, 100.0f, 0.5f}};
  for (size_t i = 128; i < 192; ++i) pair.b.descriptors.data[i] = 10 + 22;  // at a distance of 176
  GuidedOptions options;
  EXPECT_EQ(MatchGuided(pair.a, pair.b, pair.b_from_a, known, kFocalPx, options).size(), 1u);
  options.few_known = 2;
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, known, kFocalPx, options).empty());
}

TEST(MatchGuided, IsEmptyWithoutKnownMatchesOrTranslation) {
  const CameraPair pair = MakePair(10);
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, pair.b_from_a, {}, kFocalPx, {}).empty());
  EXPECT_TRUE(MatchGuided(pair.a, pair.b, Rigid3{}, kKnown, kFocalPx, {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
