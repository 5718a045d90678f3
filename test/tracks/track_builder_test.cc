#include "rovio_sfm/tracks/track_builder.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/union_find.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

using Links = std::vector<std::pair<TrackId, TrackId>>;
using Tracks = std::vector<TrackId>;

// count keypoints 20 px apart.
std::vector<Eigen::Vector2f> MakeKeypoints(int count) {
  std::vector<Eigen::Vector2f> keypoints;
  for (int i = 0; i < count; ++i) keypoints.emplace_back(20.0f * static_cast<float>(i), 5.0f);
  return keypoints;
}

PairMatches MakePair(uint32_t other_index, const std::vector<std::array<uint32_t, 2>>& matches) {
  PairMatches pair;
  pair.other_index = other_index;
  for (const auto& [a, b] : matches) pair.inliers.push_back({a, b, 1.0f, 0.5f});
  return pair;
}

TEST(TrackBuilder, BeginsATrackForEveryFeatureWithoutMatch) {
  TrackBuilder builder({});
  EXPECT_EQ(builder.Add(0, MakeKeypoints(3), {}).tracks, (Tracks{1, 2, 3}));
  const TrackUpdate update = builder.Add(4, MakeKeypoints(2), {});
  EXPECT_EQ(update.tracks, (Tracks{4, 5}));
  EXPECT_EQ(update.counts.new_tracks, 2u);
}

TEST(TrackBuilder, PutsAMatchedFeatureIntoTheEarlierTrack) {
  TrackBuilder builder({});
  builder.Add(0, MakeKeypoints(3), {});
  const TrackUpdate update = builder.Add(1, MakeKeypoints(3), {MakePair(0, {{2, 0}, {0, 1}})});
  EXPECT_EQ(update.tracks, (Tracks{3, 1, 4}));
  EXPECT_EQ(update.counts.extended, 2u);
  EXPECT_TRUE(update.links.empty());
}

TEST(TrackBuilder, BridgesAGapByAnOlderFrame) {
  TrackBuilder builder({});
  builder.Add(0, MakeKeypoints(1), {});
  builder.Add(1, MakeKeypoints(1), {});
  const TrackUpdate update =
      builder.Add(2, MakeKeypoints(1), {MakePair(1, {}), MakePair(0, {{0, 0}})});
  EXPECT_EQ(update.tracks, (Tracks{1}));
}

TEST(TrackBuilder, LinksTwoPublishedTracksByASecondMatch) {
  TrackBuilder builder({});
  builder.Add(0, MakeKeypoints(1), {});  // track 1
  builder.Add(1, MakeKeypoints(1), {});  // track 2, match with frame 0 missed
  TrackUpdate update =
      builder.Add(2, MakeKeypoints(1), {MakePair(1, {{0, 0}}), MakePair(0, {{0, 0}})});
  EXPECT_EQ(update.tracks, (Tracks{2}));
  EXPECT_EQ(update.links, (Links{{1, 2}}));
  update = builder.Add(3, MakeKeypoints(1), {MakePair(1, {{0, 0}}), MakePair(0, {{0, 0}})});
  EXPECT_EQ(update.tracks, (Tracks{1}));
  EXPECT_TRUE(update.links.empty());
  EXPECT_EQ(update.counts.agreed, 1u);
}

TEST(TrackBuilder, DropsOnlyTheMatchThatFilterF1Forbids) {
  TrackBuilder builder({});
  builder.Add(0, MakeKeypoints(2), {});  // tracks 1, 2
  builder.Add(1, MakeKeypoints(2), {MakePair(0, {{0, 0}, {1, 1}})});
  // Frame 1 says feature 0 is track 1; frame 0 says it is track 2: they share frames, so no link.
  const TrackUpdate update =
      builder.Add(2, MakeKeypoints(2), {MakePair(1, {{0, 0}}), MakePair(0, {{1, 0}, {0, 1}})});
  EXPECT_EQ(update.tracks, (Tracks{1, 3}));
  EXPECT_TRUE(update.links.empty());
  EXPECT_EQ(update.counts.refused_f1, 2u);
}

TEST(TrackBuilder, CountsTwoNearFeaturesOfAFrameAsOne) {
  TrackBuilder builder({});
  builder.Add(0, MakeKeypoints(1), {});
  builder.Add(1, MakeKeypoints(1), {MakePair(0, {{0, 0}})});
  const std::vector<Eigen::Vector2f> near = {{10.0f, 10.0f}, {11.0f, 10.0f}};
  const TrackUpdate update = builder.Add(2, near, {MakePair(1, {{0, 0}}), MakePair(0, {{0, 1}})});
  EXPECT_EQ(update.tracks, (Tracks{1, 0}));
  EXPECT_EQ(update.counts.duplicates, 1u);
  EXPECT_EQ(builder.Add(3, MakeKeypoints(1), {MakePair(2, {{1, 0}})}).tracks, (Tracks{1}));
}

TEST(TrackBuilder, ForgetsOldFramesAndCountsMatchesWithThem) {
  TrackOptions options;
  options.remembered_frames = 2;
  TrackBuilder builder(options);
  for (uint32_t i = 0; i < 3; ++i) builder.Add(i, MakeKeypoints(1), {});
  const TrackUpdate update = builder.Add(3, MakeKeypoints(1), {MakePair(0, {{0, 0}})});
  EXPECT_EQ(update.counts.unknown, 1u);
  EXPECT_EQ(update.tracks, (Tracks{4}));
}

TEST(TrackBuilder, AcceptsAFrameWithoutFeatures) {
  TrackBuilder builder({});
  EXPECT_TRUE(builder.Add(0, {}, {}).tracks.empty());
  EXPECT_EQ(builder.Add(1, MakeKeypoints(1), {MakePair(0, {})}).tracks, (Tracks{1}));
}

TEST(TrackBuilder, FindsOneTrackPerPointOfASyntheticWorld) {
  SyntheticOptions options;
  options.num_cams = 8;
  options.turn_rad = 0.0;  // so that no point comes back after it left the image
  const SyntheticWorld world = MakeSyntheticWorld(options);
  TrackBuilder builder({});
  std::map<uint32_t, std::set<TrackId>> tracks_of_point;
  UnionFind<TrackId> aliases;
  for (uint32_t n = 0; n < 8; ++n) {
    std::vector<Eigen::Vector2f> keypoints;
    for (const SyntheticView& view : world.views[n]) keypoints.push_back(view.x_px.cast<float>());
    std::vector<PairMatches> pairs;
    for (uint32_t i = 1; i <= std::min(n, 3u); ++i) {
      PairMatches pair;
      pair.other_index = n - i;
      pair.inliers = TrueMatches(world, n - i, n);
      pairs.push_back(pair);
    }
    const TrackUpdate update = builder.Add(n, keypoints, pairs);
    for (const auto& [a, b] : update.links) aliases.Union(a, b);
    for (size_t i = 0; i < keypoints.size(); ++i) {
      tracks_of_point[world.views[n][i].point].insert(update.tracks[i]);
    }
    EXPECT_EQ(update.counts.refused_f1, 0u);
  }
  std::set<TrackId> roots;
  for (const auto& [point, tracks] : tracks_of_point) {
    for (const TrackId track : tracks)
      EXPECT_EQ(aliases.Find(track), aliases.Find(*tracks.begin()));
    EXPECT_TRUE(roots.insert(aliases.Find(*tracks.begin())).second);
  }
}

TEST(TrackOptions, NamesTheBadField) {
  std::string error;
  TrackOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.remembered_frames = 0;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("remembered_frames"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
