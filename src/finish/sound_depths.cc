#include "rovio_sfm/finish/sound_depths.h"

#include <algorithm>
#include <utility>

namespace rovio_sfm {
namespace {

double DepthOf(const MapModel& model, const ModelPoint& point, const ModelView& view) {
  return (model.images[view.image].cam_from_map * point.x_in_map).z();
}

const Eigen::Vector2d& PlaceOf(const MapModel& model, const ModelView& view) {
  return model.images[view.image].keypoints[view.keypoint].x_normalized;
}

const ModelView& NearestView(const MapModel& model, const ModelPoint& point) {
  const auto is_nearer = [&](const ModelView& a, const ModelView& b) {
    return DepthOf(model, point, a) < DepthOf(model, point, b);
  };
  return *std::min_element(point.views.begin(), point.views.end(), is_nearer);
}

}  // namespace

SoundDepths::SoundDepths(const MapModel& model, size_t num_trusted,
                         const SoundDepthOptions& options)
    : options_(options), seen_(model.images.size()) {
  for (size_t i = 0; i < model.points.size(); ++i) {
    const ModelPoint& point = model.points[i];
    if (i >= num_trusted && point.views.size() < 3) continue;
    for (const ModelView& view : point.views) {
      seen_[view.image].push_back({i, PlaceOf(model, view), DepthOf(model, point, view)});
    }
  }
}

DepthRange SoundDepths::Around(uint32_t image, const Eigen::Vector2d& x_normalized,
                               size_t skipped) const {
  std::vector<std::pair<double, double>> by_distance;
  by_distance.reserve(seen_[image].size());
  for (const SeenPoint& seen : seen_[image]) {
    if (seen.point == skipped) continue;
    by_distance.emplace_back((seen.x_normalized - x_normalized).squaredNorm(), seen.depth);
  }
  if (by_distance.size() < options_.num_neighbors) return {};
  const auto end = by_distance.begin() + static_cast<std::ptrdiff_t>(options_.num_neighbors);
  std::partial_sort(by_distance.begin(), end, by_distance.end());
  const auto [nearest, farthest] = std::minmax_element(
      by_distance.begin(), end, [](const auto& a, const auto& b) { return a.second < b.second; });
  return {nearest->second / options_.max_ratio, farthest->second * options_.max_ratio};
}

size_t RemoveInconsistentDepths(size_t num_trusted, const SoundDepthOptions& options,
                                MapModel* model) {
  const SoundDepths sound(*model, num_trusted, options);
  const size_t count = model->points.size();
  std::vector<ModelPoint> kept;
  for (size_t i = 0; i < count; ++i) {
    ModelPoint& point = model->points[i];
    const ModelView nearest = NearestView(*model, point);
    const DepthRange range =
        i < num_trusted ? DepthRange{} : sound.Around(nearest.image, PlaceOf(*model, nearest), i);
    if (range.far > 0.0 && !range.Contains(DepthOf(*model, point, nearest))) continue;
    kept.push_back(std::move(point));
  }
  model->points = std::move(kept);
  return count - model->points.size();
}

}  // namespace rovio_sfm
