#include "rovio_sfm/finish/join_tracks.h"

#include <algorithm>
#include <functional>
#include <map>

#include "rovio_sfm/tracks/track_builder.h"
#include "rovio_sfm/util/union_find.h"

namespace rovio_sfm {
namespace {

using PairsByImage = std::vector<std::vector<PairMatches>>;

// What the points already say: each view with the one before it.
PairsByImage KnownPairs(const MapModel& model) {
  std::vector<std::map<uint32_t, PairMatches, std::greater<>>> known(model.images.size());
  for (const ModelPoint& point : model.points) {
    for (size_t v = 1; v < point.views.size(); ++v) {
      const ModelView &a = point.views[v - 1], &b = point.views[v];
      PairMatches& pair = known[b.image][a.image];
      pair.other_index = a.image;
      pair.inliers.push_back({a.keypoint, b.keypoint});
    }
  }
  PairsByImage pairs;
  for (auto& by_other : known) {
    pairs.emplace_back();
    for (auto& [other, pair] : by_other) pairs.back().push_back(std::move(pair));
  }
  return pairs;
}

std::vector<Eigen::Vector2f> PixelsOf(const ModelImage& image) {
  std::vector<Eigen::Vector2f> pixels;
  for (const Keypoint& keypoint : image.keypoints)
    pixels.emplace_back(keypoint.x_px, keypoint.y_px);
  return pixels;
}

TrackOptions OptionsFor(size_t num_images, double same_feature_px) {
  TrackOptions options;
  options.same_feature_px = same_feature_px;
  options.remembered_frames = static_cast<int>(std::clamp<size_t>(num_images, 1, 10000));
  return options;
}

}  // namespace

JoinedTracks JoinTracks(const MapModel& model, const PairsByImage& pairs, double same_feature_px) {
  JoinedTracks joined;
  TrackBuilder builder(OptionsFor(model.images.size(), same_feature_px));
  PairsByImage all = KnownPairs(model);
  std::vector<std::vector<TrackId>> track_of;
  UnionFind<TrackId> united;
  for (uint32_t i = 0; i < model.images.size(); ++i) {
    all[i].insert(all[i].end(), pairs[i].begin(), pairs[i].end());
    TrackUpdate update = builder.Add(i, PixelsOf(model.images[i]), all[i]);
    for (const auto& [a, b] : update.links) united.Union(a, b);
    joined.num_refused_f1 += update.counts.refused_f1;
    track_of.push_back(std::move(update.tracks));
  }
  std::map<TrackId, std::vector<ModelView>> views;
  for (uint32_t i = 0; i < track_of.size(); ++i) {
    for (uint32_t feature = 0; feature < track_of[i].size(); ++feature) {
      const TrackId track = track_of[i][feature];
      if (track != 0) views[united.Find(track)].push_back({i, feature});
    }
  }
  for (auto& [track, members] : views) {
    if (members.front().image != members.back().image) joined.tracks.push_back(std::move(members));
  }
  return joined;
}

}  // namespace rovio_sfm
