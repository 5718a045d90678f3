#include "rovio_sfm/finish/choose_neighbors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinPoints = 10;
constexpr double kOutlierShare = 0.02;  // of the depths at both ends of the range
constexpr double kRoom = 1.3;           // beyond the nearest and the farthest point

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
  surroundings->near = depths[cut] / kRoom;
  surroundings->far = depths[depths.size() - 1 - cut] * kRoom;
}

double AngleAt(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d to_a = a - x, to_b = b - x;
  return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

// How well a neighbour of that many common points seen under that angle serves.
double ScoreOf(size_t num_common, double angle_rad, const NeighborOptions& options) {
  const double off = std::log(angle_rad / options.best_angle_rad);
  return std::sqrt(static_cast<double>(num_common)) * std::exp(-off * off);
}

std::vector<uint32_t> NeighborsOf(const MapModel& model, uint32_t image,
                                  const std::vector<uint32_t>& points,
                                  const NeighborOptions& options) {
  std::map<uint32_t, std::vector<double>> angles;  // at common points, by other image
  const Eigen::Vector3d center = OriginInA(model.images[image].cam_from_map);
  for (const uint32_t point : points) {
    for (const ModelView& view : model.points[point].views) {
      if (view.image == image) continue;
      const Eigen::Vector3d other = OriginInA(model.images[view.image].cam_from_map);
      angles[view.image].push_back(AngleAt(model.points[point].x_in_map, center, other));
    }
  }
  std::vector<std::pair<double, uint32_t>> scored;
  for (auto& [other, of_other] : angles) {
    const size_t num_common = of_other.size();
    if (num_common < options.min_common) continue;
    const double angle_rad = Median(std::move(of_other));
    if (angle_rad < options.min_angle_rad || angle_rad > options.max_angle_rad) continue;
    scored.push_back({-ScoreOf(num_common, angle_rad, options), other});
  }
  std::sort(scored.begin(), scored.end());
  std::vector<uint32_t> best;
  for (const auto& [score, other] : scored) {
    if (best.size() < options.max_neighbors) best.push_back(other);
  }
  return best;
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
