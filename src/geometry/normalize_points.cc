#include "rovio_sfm/geometry/normalize_points.h"

#include <cmath>

namespace rovio_sfm {

std::optional<Eigen::Matrix3d> FindPointNormalization(const std::vector<Eigen::Vector2d>& points) {
  if (points.empty()) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& x : points) mean += x;
  mean /= static_cast<double>(points.size());
  double distance = 0.0;
  for (const Eigen::Vector2d& x : points) distance += (x - mean).norm();
  distance /= static_cast<double>(points.size());
  if (!(distance > 1e-12)) return std::nullopt;
  const double scale = std::sqrt(2.0) / distance;
  Eigen::Matrix3d transform;
  transform << scale, 0.0, -scale * mean.x(), 0.0, scale, -scale * mean.y(), 0.0, 0.0, 1.0;
  return transform;
}

}  // namespace rovio_sfm
