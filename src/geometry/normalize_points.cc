#include "rovio_sfm/geometry/normalize_points.h"

#include <Eigen/Geometry>
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

std::optional<NormalizedMatches> NormalizeMatches(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b,
                                                  size_t min_matches) {
  if (points_a.size() < min_matches || points_a.size() != points_b.size()) return std::nullopt;
  const auto transform_a = FindPointNormalization(points_a);
  const auto transform_b = FindPointNormalization(points_b);
  if (!transform_a || !transform_b) return std::nullopt;
  NormalizedMatches matches{*transform_a, *transform_b, {}, {}};
  matches.x_a.reserve(points_a.size());
  matches.x_b.reserve(points_b.size());
  for (const Eigen::Vector2d& point : points_a) {
    matches.x_a.push_back(*transform_a * point.homogeneous());
  }
  for (const Eigen::Vector2d& point : points_b) {
    matches.x_b.push_back(*transform_b * point.homogeneous());
  }
  return matches;
}

}  // namespace rovio_sfm
