#include "rovio_sfm/dense/fuse_depths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "rovio_sfm/dense/project_depth.h"

namespace rovio_sfm {
namespace {

using VoxelKey = std::array<int32_t, 3>;

struct HashOfKey {
  size_t operator()(const VoxelKey& key) const {
    uint64_t hash = 0;
    for (const int32_t part : key) {
      hash = (hash ^ static_cast<uint32_t>(part)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

struct Voxel {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  uint32_t num_points = 0, num_views = 0;
  uint32_t last_view = UINT32_MAX;
};

using VoxelGrid = std::unordered_map<VoxelKey, Voxel, HashOfKey>;

VoxelKey KeyOf(const Eigen::Vector3d& x, double voxel) {
  VoxelKey key{};
  for (int i = 0; i < 3; ++i) {
    key[static_cast<size_t>(i)] = static_cast<int32_t>(std::floor(x[i] / voxel));
  }
  return key;
}

// Of the surface through three neighbouring pixels, towards the camera; zero where one is unknown
// or lies on something else.
Eigen::Vector3f NormalAt(const DepthView& view, const DepthMap& depth, int row, int col) {
  constexpr float kMaxStep = 0.05f;  // relative, of a surface between neighbouring pixels
  if (row + 1 >= depth.rows || col + 1 >= depth.cols) return Eigen::Vector3f::Zero();
  const float here = depth.at<float>(row, col), right = depth.at<float>(row, col + 1),
              below = depth.at<float>(row + 1, col);
  for (const float beside : {right, below}) {
    if (beside <= 0.0f || std::abs(beside - here) > kMaxStep * here) return Eigen::Vector3f::Zero();
  }
  const Eigen::Vector3d x = PointOfPixel(view, {col, row}, here);
  const Eigen::Vector3d to_right = PointOfPixel(view, {col + 1, row}, right) - x;
  const Eigen::Vector3d to_below = PointOfPixel(view, {col, row + 1}, below) - x;
  return to_below.cross(to_right).normalized().cast<float>();
}

void AddView(const DepthView& view, const DepthMap& depth, const cv::Mat& telling, uint32_t index,
             double voxel, VoxelGrid* grid) {
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const float here = depth.at<float>(row, col);
      if (here <= 0.0f || telling.at<uchar>(row, col) == 0) continue;
      const Eigen::Vector3d x = PointOfPixel(view, {col, row}, here);
      Voxel& sum = (*grid)[KeyOf(x, voxel)];
      const cv::Vec3b& bgr = view.bgr.at<cv::Vec3b>(row, col);
      sum.position += x.cast<float>();
      sum.normal += NormalAt(view, depth, row, col);
      sum.color += Eigen::Vector3f(bgr[2], bgr[1], bgr[0]);
      ++sum.num_points;
      if (sum.last_view != index) ++sum.num_views;
      sum.last_view = index;
    }
  }
}

// How many views see through a point to something farther.
uint32_t CountLookThrough(const Eigen::Vector3d& x, const std::vector<DepthView>& views,
                          const std::vector<DepthMap>& depths, double free_gap) {
  uint32_t count = 0;
  for (size_t i = 0; i < views.size(); ++i) {
    const auto seen = SeePoint(views[i], x);
    if (!seen) continue;
    const double found = depths[i].at<float>(seen->pixel);
    if (found > seen->depth * (1.0 + free_gap)) ++count;
  }
  return count;
}

DensePoint PointOf(const Voxel& sum) {
  const auto count = static_cast<float>(sum.num_points);
  const Eigen::Vector3f color = sum.color / count;
  DensePoint point;
  point.position = sum.position / count;
  if (sum.normal.norm() > 0.0f) point.normal = sum.normal.normalized();
  point.color = {static_cast<uint8_t>(color.x()), static_cast<uint8_t>(color.y()),
                 static_cast<uint8_t>(color.z())};
  point.num_views = sum.num_views;
  return point;
}

}  // namespace

PointCloud FuseDepths(const std::vector<DepthView>& views, const std::vector<DepthMap>& depths,
                      const std::vector<cv::Mat>& telling, const FusionOptions& options) {
  VoxelGrid grid;
  for (size_t i = 0; i < views.size(); ++i) {
    AddView(views[i], depths[i], telling[i], static_cast<uint32_t>(i), options.voxel, &grid);
  }
  std::map<VoxelKey, const Voxel*> ordered;
  for (const auto& [key, voxel] : grid) ordered[key] = &voxel;
  PointCloud cloud;
  for (const auto& [key, voxel] : ordered) {
    DensePoint point = PointOf(*voxel);
    const uint32_t num_through =
        CountLookThrough(point.position.cast<double>(), views, depths, options.free_gap);
    if (num_through > options.max_free_share * voxel->num_views) continue;
    cloud.push_back(point);
  }
  return cloud;
}

}  // namespace rovio_sfm
