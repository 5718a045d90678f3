#include "rovio_sfm/finish/join_tracks.h"

#include <gtest/gtest.h>

#include <array>

namespace rovio_sfm {
namespace {

constexpr double kSameFeaturePx = 1.5;

// Images of four features, 20 px apart, and a point that the first of each of the first two see.
MapModel FourImages() {
  MapModel model;
  for (uint32_t i = 0; i < 4; ++i) {
    ModelImage image;
    for (int k = 0; k < 4; ++k) {
      Keypoint keypoint;
      keypoint.x_px = 20.0f * static_cast<float>(k);
      image.keypoints.push_back(keypoint);
    }
    model.images.push_back(image);
  }
  ModelPoint point;
  point.views = {{0, 0}, {1, 0}};
  model.points.push_back(point);
  return model;
}

PairMatches Pair(uint32_t other, const std::vector<std::array<uint32_t, 2>>& matches) {
  PairMatches pair;
  pair.other_index = other;
  for (const auto& [a, b] : matches) pair.inliers.push_back({a, b, 1.0f, 0.5f});
  return pair;
}

std::vector<std::vector<std::array<uint32_t, 2>>> ViewsOf(const JoinedTracks& joined) {
  std::vector<std::vector<std::array<uint32_t, 2>>> tracks;
  for (const auto& track : joined.tracks) {
    tracks.emplace_back();
    for (const ModelView& view : track) tracks.back().push_back({view.image, view.keypoint});
  }
  return tracks;
}

TEST(JoinTracks, HoldsTogetherWhatPointsSeeAndMatchesJoin) {
  const JoinedTracks joined =
      JoinTracks(FourImages(), {{}, {}, {Pair(1, {{0, 2}, {3, 3}})}, {}}, kSameFeaturePx);
  EXPECT_EQ(ViewsOf(joined), (std::vector<std::vector<std::array<uint32_t, 2>>>{
                                 {{0, 0}, {1, 0}, {2, 2}}, {{1, 3}, {2, 3}}}));
}

TEST(JoinTracks, RefusesTwoPlacesOfOneImage) {
  const JoinedTracks joined = JoinTracks(
      FourImages(), {{}, {}, {Pair(1, {{1, 1}})}, {Pair(2, {{1, 3}}), Pair(1, {{0, 3}})}},
      kSameFeaturePx);
  EXPECT_EQ(joined.num_refused_f1, 1u);  // features 0 and 1 of image 1 lie 20 px apart
  EXPECT_EQ(ViewsOf(joined), (std::vector<std::vector<std::array<uint32_t, 2>>>{
                                 {{0, 0}, {1, 0}}, {{1, 1}, {2, 1}, {3, 3}}}));
}

TEST(JoinTracks, IsEmptyForAnEmptyModel) {
  EXPECT_TRUE(JoinTracks({}, {}, kSameFeaturePx).tracks.empty());
}

}  // namespace
}  // namespace rovio_sfm
