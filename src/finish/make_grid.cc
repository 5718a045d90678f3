#include "rovio_sfm/finish/make_grid.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

namespace rovio_sfm {
namespace {

// How often rays, and points, fell into cells.
class CellCounts {
 public:
  CellCounts(const Eigen::AlignedBox2d& area, double resolution_m)
      : resolution_m_(resolution_m),
        origin_m_(area.min()),
        width_(static_cast<int>(std::ceil(area.sizes().x() / resolution_m))),
        height_(static_cast<int>(std::ceil(area.sizes().y() / resolution_m))),
        rays_(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0.0),
        points_(rays_.size(), 0) {}

  void AddPoint(const Eigen::Vector2d& x_m) {
    if (const auto cell = CellOf(x_m)) ++points_[*cell];
  }

  // Every cell between, but for the last two before the point: it may stand at their edge.
  void AddRay(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    const double length_m = (to_m - from_m).norm(), step_m = 0.5 * resolution_m_;
    for (double way_m = 0.0; way_m < length_m - 2.0 * resolution_m_; way_m += step_m) {
      if (const auto cell = CellOf(from_m + way_m / length_m * (to_m - from_m))) {
        rays_[*cell] += 0.5;
      }
    }
  }

  void AddDisc(const Eigen::Vector2d& center_m, double radius_m, double weight) {
    for (double y = -radius_m; y <= radius_m; y += resolution_m_) {
      for (double x = -radius_m; x <= radius_m; x += resolution_m_) {
        if (std::hypot(x, y) > radius_m) continue;
        if (const auto cell = CellOf(center_m + Eigen::Vector2d(x, y))) rays_[*cell] += weight;
      }
    }
  }

  // A cell that many more rays pass than points lie in is free: what stands there is thin or wrong.
  OccupancyGridMap Judge(const GridOptions& options) const {
    constexpr double kRaysPerPoint = 10.0;
    OccupancyGridMap grid{resolution_m_, origin_m_, width_, height_, {}};
    for (size_t i = 0; i < rays_.size(); ++i) {
      const bool occupied =
          points_[i] >= options.min_points && rays_[i] < kRaysPerPoint * points_[i];
      const bool free = !occupied && rays_[i] >= options.min_free;
      grid.cells.push_back(occupied ? GridCell::kOccupied
                           : free   ? GridCell::kFree
                                    : GridCell::kUnknown);
    }
    return grid;
  }

 private:
  std::optional<size_t> CellOf(const Eigen::Vector2d& x_m) const {
    const int column = static_cast<int>(std::floor((x_m.x() - origin_m_.x()) / resolution_m_));
    const int row = static_cast<int>(std::floor((x_m.y() - origin_m_.y()) / resolution_m_));
    if (column < 0 || row < 0 || column >= width_ || row >= height_) return std::nullopt;
    return static_cast<size_t>(row) * static_cast<size_t>(width_) + static_cast<size_t>(column);
  }

  double resolution_m_;
  Eigen::Vector2d origin_m_;
  int width_, height_;
  std::vector<double> rays_;
  std::vector<int> points_;
};

// The floor that the map shows. The level frame is as level as the camera is mounted: half a degree
// lifts the floor by 4 cm at 4 m.
class Floor {
 public:
  // The plane of the points near z = 0; z = 0 itself where they are few or all in one line.
  explicit Floor(const std::vector<Eigen::Vector3d>& points) {
    for (const double reach_m : {0.10, 0.05, 0.03}) {
      std::vector<Eigen::Vector3d> near;
      for (const Eigen::Vector3d& x : points) {
        if (std::abs(HeightOf(x)) < reach_m) near.push_back(x);
      }
      if (!Fit(near)) return;
    }
  }

  double HeightOf(const Eigen::Vector3d& x) const {
    return x.z() - offset_m_ - slope_.dot(x.head<2>());
  }

 private:
  // False: nothing was changed.
  bool Fit(const std::vector<Eigen::Vector3d>& points) {
    constexpr size_t kMinPoints = 100;
    constexpr double kMinSpread_m = 0.3;  // standard deviation along the shorter way
    if (points.size() < kMinPoints) return false;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& x : points) mean += x / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& x : points) {
      spread += (x - mean) * (x - mean).transpose() / static_cast<double>(points.size());
    }
    const Eigen::Matrix2d flat = spread.topLeftCorner<2, 2>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> along(flat);
    if (along.eigenvalues()[0] < kMinSpread_m * kMinSpread_m) return false;
    slope_ = flat.inverse() * spread.topRightCorner<2, 1>();
    offset_m_ = mean.z() - slope_.dot(mean.head<2>());
    return true;
  }

  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();
  double offset_m_ = 0.0;
};

bool IsInBand(double height_m, const GridOptions& options) {
  return height_m >= options.min_height_m && height_m <= options.max_height_m;
}

// Cameras, and points in the band not too far from them: a stray one does not make a grid of a
// town.
Eigen::AlignedBox2d AreaOf(const MapModel& model, const PointCloud* dense, const Floor& floor,
                           const GridOptions& options) {
  Eigen::AlignedBox2d cameras;
  for (const ModelImage& image : model.images)
    cameras.extend(OriginInA(image.cam_from_map).head<2>());
  Eigen::AlignedBox2d area = cameras;
  const auto extend = [&](const Eigen::Vector3d& x) {
    const Eigen::Vector2d place = x.head<2>();
    if (IsInBand(floor.HeightOf(x), options) &&
        cameras.exteriorDistance(place) < options.max_reach_m)
      area.extend(place);
  };
  for (const ModelPoint& point : model.points) extend(point.x_in_map);
  if (dense != nullptr) {
    for (const DensePoint& point : *dense) extend(point.position.cast<double>());
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(options.margin_m);
  return {area.min() - margin, area.max() + margin};
}

// A ray is over the floor only where it runs in the robot's height: from a camera in the band to a
// point in it. What lies above or on the floor is seen across free floor up to there.
void AddRays(const MapModel& model, const Floor& floor, const GridOptions& options,
             CellCounts* counts) {
  for (const ModelPoint& point : model.points) {
    const double height_m = floor.HeightOf(point.x_in_map);
    if (height_m < -options.min_height_m || height_m > options.max_height_m) continue;
    const bool occupies = IsInBand(height_m, options);
    if (occupies) counts->AddPoint(point.x_in_map.head<2>());
    for (const ModelView& view : point.views) {
      const Eigen::Vector3d center = OriginInA(model.images[view.image].cam_from_map);
      const double range_m = (point.x_in_map - center).norm();
      if (range_m > options.max_range_m) continue;
      counts->AddRay(center.head<2>(), point.x_in_map.head<2>());
      if (occupies) counts->AddPoint(point.x_in_map.head<2>());
    }
  }
}

void AddDense(const PointCloud& dense, const Floor& floor, const GridOptions& options,
              CellCounts* counts) {
  for (const DensePoint& point : dense) {
    const Eigen::Vector3d x = point.position.cast<double>();
    if (!IsInBand(floor.HeightOf(x), options)) continue;
    for (uint32_t i = 0; i < point.num_views; ++i) counts->AddPoint(x.head<2>());
  }
}

Floor FindFloor(const MapModel& model, const PointCloud* dense) {
  std::vector<Eigen::Vector3d> points;
  for (const ModelPoint& point : model.points) points.push_back(point.x_in_map);
  if (dense != nullptr) {
    for (const DensePoint& point : *dense) points.push_back(point.position.cast<double>());
  }
  return Floor(points);
}

}  // namespace

OccupancyGridMap MakeGrid(const MapModel& model, const PointCloud* dense,
                          const GridOptions& options) {
  if (model.length_unit != "metres") {
    throw std::invalid_argument("grid: unit of the map = " + model.length_unit +
                                ": expected metres; a grid needs a metric map");
  }
  if (model.images.empty()) return {};
  const Floor floor = FindFloor(model, dense);
  CellCounts counts(AreaOf(model, dense, floor, options), options.resolution_m);
  AddRays(model, floor, options, &counts);
  if (dense != nullptr) AddDense(*dense, floor, options, &counts);
  for (const ModelImage& image : model.images) {
    const Eigen::Vector2d center = OriginInA(image.cam_from_map).head<2>();
    counts.AddDisc(center, options.robot_radius_m, options.min_free + 1.0);
  }
  return counts.Judge(options);
}

}  // namespace rovio_sfm
