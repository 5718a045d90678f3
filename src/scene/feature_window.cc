#include "rovio_sfm/scene/feature_window.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

float Distance(const uint8_t* a, const uint8_t* b, uint32_t length) {
  int sum = 0;
  for (uint32_t i = 0; i < length; ++i) {
    const int difference = static_cast<int>(a[i]) - static_cast<int>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(static_cast<float>(sum));
}

}  // namespace

FeatureGrid::FeatureGrid(const std::vector<Eigen::Vector2d>& points, double cell) : cell_(cell) {
  for (uint32_t i = 0; i < points.size(); ++i) cells_[Key(points[i])].push_back(i);
}

std::vector<uint32_t> FeatureGrid::Near(const Eigen::Vector2d& point) const {
  std::vector<uint32_t> near;
  const auto [x, y] = Key(point);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const auto it = cells_.find({x + dx, y + dy});
      if (it != cells_.end()) near.insert(near.end(), it->second.begin(), it->second.end());
    }
  }
  return near;
}

std::pair<int, int> FeatureGrid::Key(const Eigen::Vector2d& point) const {
  return {static_cast<int>(std::floor(point.x() / cell_)),
          static_cast<int>(std::floor(point.y() / cell_))};
}

DescriptorReader::DescriptorReader(const FrameStore& store, DriveId drive)
    : store_(store), drive_(std::move(drive)) {}

const uint8_t* DescriptorReader::Row(const Observation& observation, uint32_t length) {
  const Descriptors* descriptors = Of(observation.frame);
  const bool known = descriptors != nullptr && descriptors->length == length;
  return known ? descriptors->Row(observation.feature) : nullptr;
}

const Descriptors* DescriptorReader::Of(uint32_t frame) {
  auto [it, is_new] = cache_.try_emplace(frame);
  if (is_new) it->second = store_.Get({drive_, frame});
  if (it->second == nullptr || it->second->descriptors.Count() == 0 ||
      it->second->descriptors.metric != DescriptorMetric::kL2) {
    return nullptr;
  }
  return &it->second->descriptors;
}

std::optional<uint32_t> FindFeature(const FeatureWindow& window, const Eigen::Vector2d& predicted,
                                    const uint8_t* appearance) {
  float best = window.max_distance, second = HUGE_VALF;
  std::optional<uint32_t> found;
  for (const uint32_t i : window.grid.Near(predicted)) {
    if ((window.frame.points[i] - predicted).norm() > window.radius) continue;
    const float distance =
        Distance(appearance, window.descriptors.Row(i), window.descriptors.length);
    if (distance < best) {
      second = found ? best : second;
      best = distance;
      found = i;
    } else {
      second = std::min(second, distance);
    }
  }
  if (!found || best > window.max_ratio * second) return std::nullopt;
  const double error = (window.frame.points[*found] - predicted).norm();
  if (error > window.max_error_sigmas * window.frame.sigmas[*found]) return std::nullopt;
  return found;
}

}  // namespace rovio_sfm
