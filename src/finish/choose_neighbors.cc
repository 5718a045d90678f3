#include "rovio_sfm/finish/choose_neighbors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinPoints = 10;
constexpr double kOutlierShare = 0.02;  // of the depths at both ends of the range
constexpr double kNearRoom = 1.3;       // before the nearest point
// Behind the farthest: pictures of far surfaces have few points, and planes are few there.
constexpr double kFarRoom = 3.25;

std::vector<std::vector<uint32_t>> PointsByImage(const MapModel& model) {
  std::vector<std::vector<uint32_t>> points(model.images.size());
  for (uint32_t i = 0; i < model.points.size(); ++i) {
    for (const ModelView& view : model.points[i].views) points[view.image].push_back(i);
  }
  return points;
}

void SetRange(const MapModel& model, const ModelImage& image, const std::vector<uint32_t>& points,
              ImageSurroundings* surroundings) {
  std::vector<double> depths;
  for (const uint32_t point : points) {
    const double depth = (image.cam_from_map * model.points[point].x_in_map).z();
    if (depth > 0.0) depths.push_back(depth);
  }
  if (depths.size() < kMinPoints) return;
  std::sort(depths.begin(), depths.end());
  const auto cut = static_cast<size_t>(kOutlierShare * static_cast<double>(depths.size()));
  surroundings->near = depths[cut] / kNearRoom;
  surroundings->far = depths[depths.size() - 1 - cut] * kFarRoom;
  surroundings->typical = depths[depths.size() / 2];
}

// How well two pictures from there measure a point: by the angle under which both see it, and by
// how different its sizes are in them. 0: not at all.
double QualityAt(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                 const NeighborOptions& options) {
  const double angle_rad = ParallaxAngle(a, b, x);
  if (angle_rad < options.min_angle_rad || angle_rad > options.max_angle_rad) return 0.0;
  const double off = std::log(angle_rad / options.best_angle_rad);
  const double sizes = (x - a).norm() / (x - b).norm();
  return std::exp(-off * off) * std::min(sizes, 1.0 / sizes);
}

// Where the picture, without distortion, shows a point: from (0, 0) to (1, 1).
std::optional<Eigen::Vector2d> PlaceInPicture(const MapModel& model, const ModelImage& image,
                                              const Eigen::Vector3d& x_in_map) {
  const Camera& camera = model.cameras[image.camera];
  const Eigen::Vector3d x = image.cam_from_map * x_in_map;
  if (!(x.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d place((camera.fx * x.x() / x.z() + camera.cx) / camera.width,
                              (camera.fy * x.y() / x.z() + camera.cy) / camera.height);
  if (!(place.minCoeff() >= 0.0 && place.maxCoeff() < 1.0)) return std::nullopt;
  return place;
}

// By point the share in its cell of the picture, so that every part of it counts the same.
std::vector<double> WeighByCell(const MapModel& model, const ModelImage& image,
                                const std::vector<uint32_t>& points) {
  constexpr int kCells = 8;  // along either side
  std::map<int, double> counts;
  std::vector<int> cells;
  for (const uint32_t point : points) {
    const auto place = PlaceInPicture(model, image, model.points[point].x_in_map);
    cells.push_back(place ? static_cast<int>(kCells * place->x()) +
                                kCells * static_cast<int>(kCells * place->y())
                          : -1);
    ++counts[cells.back()];
  }
  std::vector<double> weights;
  for (const int cell : cells) weights.push_back(cell < 0 ? 0.0 : 1.0 / counts.at(cell));
  return weights;
}

// The qualities at the points, by other image that has enough of them in common.
std::map<uint32_t, std::vector<double>> FindCandidates(const MapModel& model, uint32_t image,
                                                       const std::vector<uint32_t>& points,
                                                       const NeighborOptions& options) {
  std::map<uint32_t, size_t> num_common;
  for (const uint32_t point : points) {
    for (const ModelView& view : model.points[point].views) ++num_common[view.image];
  }
  num_common.erase(image);
  const Eigen::Vector3d center = OriginInA(model.images[image].cam_from_map);
  std::map<uint32_t, std::vector<double>> candidates;
  for (const auto& [other, count] : num_common) {
    if (count < options.min_common) continue;
    const ModelImage& there = model.images[other];
    const Eigen::Vector3d other_center = OriginInA(there.cam_from_map);
    for (const uint32_t point : points) {
      const Eigen::Vector3d& x = model.points[point].x_in_map;
      const bool is_seen = PlaceInPicture(model, there, x).has_value();
      candidates[other].push_back(is_seen ? QualityAt(x, center, other_center, options) : 0.0);
    }
  }
  return candidates;
}

// What a further view adds to those of a point, whose qualities come from the best on: each counts
// less than the one before.
double GainOf(double quality, const std::vector<double>& chosen) {
  constexpr double kLess = 0.6;
  double factor = 1.0;
  auto worse = chosen.begin();
  for (; worse != chosen.end() && *worse >= quality; ++worse) factor *= kLess;
  double gain = factor * quality;
  for (; worse != chosen.end(); ++worse) {
    gain -= (1.0 - kLess) * factor * *worse;
    factor *= kLess;
  }
  return gain;
}

// By point, the qualities of the views that are chosen, the best first.
using ChosenViews = std::vector<std::vector<double>>;

double TotalGain(const std::vector<double>& qualities, const std::vector<double>& weights,
                 const ChosenViews& chosen) {
  double gain = 0.0;
  for (size_t i = 0; i < weights.size(); ++i) gain += weights[i] * GainOf(qualities[i], chosen[i]);
  return gain;
}

void AddView(const std::vector<double>& qualities, ChosenViews* chosen) {
  for (size_t i = 0; i < qualities.size(); ++i) {
    std::vector<double>& views = (*chosen)[i];
    const auto at =
        std::upper_bound(views.begin(), views.end(), qualities[i], std::greater<double>());
    views.insert(at, qualities[i]);
  }
}

// One after the other the image that adds most, so that what leaves the picture of one, as it does
// ahead of a robot that drives forward, is seen by others.
std::vector<uint32_t> NeighborsOf(const MapModel& model, uint32_t image,
                                  const std::vector<uint32_t>& points,
                                  const NeighborOptions& options) {
  const std::vector<double> weights = WeighByCell(model, model.images[image], points);
  auto candidates = FindCandidates(model, image, points, options);
  ChosenViews chosen(points.size());
  std::vector<uint32_t> neighbors;
  while (neighbors.size() < options.max_neighbors) {
    auto best = candidates.end();
    double most = 0.0;
    for (auto it = candidates.begin(); it != candidates.end(); ++it) {
      const double gain = TotalGain(it->second, weights, chosen);
      if (gain > most) most = gain, best = it;
    }
    if (best == candidates.end()) break;
    AddView(best->second, &chosen);
    neighbors.push_back(best->first);
    candidates.erase(best);
  }
  return neighbors;
}

}  // namespace

std::vector<ImageSurroundings> ChooseNeighbors(const MapModel& model,
                                               const NeighborOptions& options) {
  const std::vector<std::vector<uint32_t>> points = PointsByImage(model);
  std::vector<ImageSurroundings> surroundings(model.images.size());
  for (uint32_t i = 0; i < model.images.size(); ++i) {
    SetRange(model, model.images[i], points[i], &surroundings[i]);
    surroundings[i].neighbors = NeighborsOf(model, i, points[i], options);
  }
  return surroundings;
}

}  // namespace rovio_sfm
