#include "rovio_sfm/sfm/estimate_floor_scale.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxCameras = 100, kMaxPoints = 4000;
constexpr int kIterations = 10;
constexpr double kDependentPoints = 10.0;      // so many share the errors of their cameras
constexpr double kLeastResidualShare = 0.005;  // of the height; no floor is flatter
constexpr double kMaxGapShare = 0.1;           // of the height: the floor's points
constexpr double kMaxBelowShare = 0.1;         // points under the floor per point of it
constexpr double kMaxSigma = 0.2;              // a less certain scale is none
constexpr size_t kMinPoints = 30;              // of the floor
constexpr size_t kMinFloorCameras = 5;
constexpr double kMinSpreadHeights = 0.5;  // of the floor's points, across their narrower side

// Cameras and points in a frame with z up, its origin amid the cameras. `ratio` is a camera's
// height over the mean height.
struct Upright {
  std::vector<Eigen::Vector3d> cameras, points;
  std::vector<double> ratios;
  double mean_height_m = 0.0;
};

// The floor z = slope . (x, y) + offset, and the mean height of the cameras over it; map units.
struct Floor {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double offset = 0.0;
  double height = 0.0;
  double height_sigma = 0.0;

  double Above(const Eigen::Vector3d& x) const { return x.z() - slope.dot(x.head<2>()) - offset; }
};

template <typename T>
std::vector<T> Thin(const std::vector<T>& all, size_t max_count) {
  const size_t step = (all.size() + max_count - 1) / max_count;
  if (step <= 1) return all;
  std::vector<T> some;
  for (size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

Upright MakeUpright(const std::vector<FloorCamera>& cameras,
                    const std::vector<Eigen::Vector3d>& points) {
  Upright upright;
  Eigen::Vector3d up = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
  const double count = static_cast<double>(cameras.size());
  for (const FloorCamera& camera : cameras) {
    up += camera.up_in_map / count;
    middle += camera.center_in_map / count;
    upright.mean_height_m += camera.height_m / count;
  }
  const auto turn = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ());
  for (const FloorCamera& camera : cameras) {
    upright.cameras.push_back(turn * (camera.center_in_map - middle));
    upright.ratios.push_back(camera.height_m / upright.mean_height_m);
  }
  for (const Eigen::Vector3d& point : points) upright.points.push_back(turn * (point - middle));
  return upright;
}

double SquaredDistanceToPath(const Upright& scene, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& camera : scene.cameras) {
    least = std::min(least, (camera - point).head<2>().squaredNorm());
  }
  return least;
}

// How far below the cameras the deepest dense layer of points lies; nothing without one. Only
// points near the path count: farther ones are moved too much by a wrong up direction.
std::optional<double> FindLayer(const Upright& scene, double up_sigma_rad) {
  const double reach = kMaxGapShare / up_sigma_rad;
  std::vector<double> depths;
  for (const Eigen::Vector3d& point : scene.points) {
    const double depth = -point.z();
    if (depth <= 0.0 || SquaredDistanceToPath(scene, point) > std::pow(reach * depth, 2)) continue;
    depths.push_back(depth);
  }
  std::sort(depths.begin(), depths.end());
  std::vector<size_t> counts(depths.size());  // of the layer that begins at this depth
  for (size_t i = 0, end = 0; i < depths.size(); ++i) {
    while (end < depths.size() && depths[end] <= depths[i] * (1.0 + 2.0 * kMaxGapShare)) {
      ++end;
    }
    counts[i] = end - i;
  }
  if (counts.empty()) return std::nullopt;
  const size_t most = *std::max_element(counts.begin(), counts.end());
  const double enough =
      std::max(static_cast<double>(kMinPoints), kMaxBelowShare * static_cast<double>(most));
  for (size_t i = counts.size(); i-- > 0;) {
    if (static_cast<double>(counts[i]) >= enough) return depths[i + counts[i] / 2];
  }
  return std::nullopt;
}

std::vector<Eigen::Vector3d> PointsOn(const Floor& floor, const Upright& scene, double gap) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& point : scene.points) {
    if (std::abs(floor.Above(point)) <= gap) points.push_back(point);
  }
  return points;
}

double RootMeanSquare(double sum, size_t count) {
  return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

double CameraResidual(const Floor& floor, const Upright& scene) {
  double sum = 0.0;
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    sum += std::pow(floor.Above(scene.cameras[i]) - scene.ratios[i] * floor.height, 2);
  }
  return RootMeanSquare(sum, scene.cameras.size());
}

double PointResidual(const Floor& floor, const std::vector<Eigen::Vector3d>& points) {
  double sum = 0.0;
  for (const Eigen::Vector3d& point : points) sum += std::pow(floor.Above(point), 2);
  return RootMeanSquare(sum, points.size());
}

// Least squares over cameras (at their heights), points (on the floor) and a level prior; every
// kind weighted by its residuals from the last floor.
Floor Refit(const Floor& last, const Upright& scene, const std::vector<Eigen::Vector3d>& points,
            double up_sigma_rad) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();  // of slope, offset, height
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const auto add = [&](const Eigen::Vector3d& x, double ratio, double sigma) {
    const Eigen::Vector4d row(x.x(), x.y(), 1.0, ratio);
    normal += row * row.transpose() / (sigma * sigma);
    right += row * x.z() / (sigma * sigma);
  };
  const double least = kLeastResidualShare * last.height;
  const double camera_sigma = std::max(least, CameraResidual(last, scene));
  const double point_sigma = std::max(least, PointResidual(last, points));
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    add(scene.cameras[i], scene.ratios[i], camera_sigma);
  }
  for (const auto& point : points) add(point, 0.0, point_sigma * std::sqrt(kDependentPoints));
  normal.topLeftCorner<2, 2>().diagonal().array() += std::pow(up_sigma_rad, -2);
  const Eigen::Matrix4d covariance = normal.inverse();
  const Eigen::Vector4d solution = covariance * right;
  return {solution.head<2>(), solution[2], solution[3], std::sqrt(covariance(3, 3))};
}

bool IsSpread(const std::vector<Eigen::Vector3d>& points, double height) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& point : points) mean += point.head<2>() / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& point : points) {
    const Eigen::Vector2d away = point.head<2>() - mean;
    scatter += away * away.transpose() / static_cast<double>(points.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter, Eigen::EigenvaluesOnly);
  return axes.eigenvalues()[0] >= std::pow(kMinSpreadHeights * height, 2);
}

bool IsFloor(const Floor& floor, const Upright& scene) {
  if (!(floor.height > 0.0) || !std::isfinite(floor.height_sigma)) return false;
  const double gap = kMaxGapShare * floor.height;
  const auto points = PointsOn(floor, scene, gap);
  if (points.size() < kMinPoints) return false;
  const auto num_below =
      std::count_if(scene.points.begin(), scene.points.end(),
                    [&](const Eigen::Vector3d& point) { return floor.Above(point) < -2.0 * gap; });
  return static_cast<double>(num_below) <= kMaxBelowShare * static_cast<double>(points.size()) &&
         CameraResidual(floor, scene) <= gap && IsSpread(points, floor.height);
}

}  // namespace

std::optional<MapScale> EstimateFloorScale(const std::vector<FloorCamera>& cameras,
                                           const std::vector<Eigen::Vector3d>& points_in_map,
                                           const FloorUncertainty& uncertainty) {
  if (cameras.size() < kMinFloorCameras) return std::nullopt;
  const Upright scene = MakeUpright(Thin(cameras, kMaxCameras), Thin(points_in_map, kMaxPoints));
  const std::optional<double> depth = FindLayer(scene, uncertainty.up_sigma_rad);
  if (!depth) return std::nullopt;
  Floor floor{Eigen::Vector2d::Zero(), -*depth, *depth, 0.0};
  for (int i = 0; i < kIterations; ++i) {
    const auto points = PointsOn(floor, scene, kMaxGapShare * floor.height);
    floor = Refit(floor, scene, points, uncertainty.up_sigma_rad);
    if (!(floor.height > 0.0)) return std::nullopt;
  }
  if (!IsFloor(floor, scene)) return std::nullopt;
  const double height = floor.height / std::sqrt(1.0 + floor.slope.squaredNorm());
  const double sigma_log = std::hypot(floor.height_sigma / floor.height, uncertainty.height_sigma);
  if (!(sigma_log <= kMaxSigma)) return std::nullopt;
  return MapScale{scene.mean_height_m / height, sigma_log, "camera height"};
}

}  // namespace rovio_sfm
