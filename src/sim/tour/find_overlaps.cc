#include "rovio_sfm/sim/tour/find_overlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rovio_sfm::sim {
namespace {

constexpr double kDepthTolerance = 0.04;  // relative; depth is sampled coarsely

// True if the point lies at the depth that b's map has around its pixel: a slanted floor spans a
// range of depths between neighbouring samples.
bool Sees(const Camera& camera, const Eigen::Vector3d& x_in_b, const cv::Mat& depth, int step_px) {
  if (x_in_b.z() <= 0.02) return false;
  const Eigen::Vector2d normalized = x_in_b.head<2>() / x_in_b.z();
  if (normalized.squaredNorm() > 1.0) return false;
  const Eigen::Vector2d x_px = PixelFromNormalized(camera, normalized);
  const int col = static_cast<int>(std::floor((x_px.x() + 0.5) / step_px));
  const int row = static_cast<int>(std::floor((x_px.y() + 0.5) / step_px));
  if (col < 0 || row < 0 || col >= depth.cols || row >= depth.rows) return false;
  double nearest = depth.at<float>(row, col), farthest = nearest;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, depth.rows - 1); ++r) {
    nearest = std::min<double>(nearest, depth.at<float>(r, col));
    farthest = std::max<double>(farthest, depth.at<float>(r, col));
  }
  for (int c = std::max(col - 1, 0); c <= std::min(col + 1, depth.cols - 1); ++c) {
    nearest = std::min<double>(nearest, depth.at<float>(row, c));
    farthest = std::max<double>(farthest, depth.at<float>(row, c));
  }
  return x_in_b.z() > (1.0 - kDepthTolerance) * nearest &&
         x_in_b.z() < (1.0 + kDepthTolerance) * farthest;
}

double AxisAngle(const Rigid3& a, const Rigid3& b) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  return std::acos(std::clamp((a.rotation * z).dot(b.rotation * z), -1.0, 1.0));
}

std::optional<ViewOverlap> Compare(const Camera& camera, const DepthView& a, const DepthView& b,
                                   int step_px) {
  ViewOverlap overlap;
  overlap.angle_rad = AxisAngle(a.world_from_camera, b.world_from_camera);
  if (overlap.angle_rad > 0.5 * M_PI) return std::nullopt;
  overlap.covisible_share =
      0.5 * (CovisibleShare(camera, a, b, step_px) + CovisibleShare(camera, b, a, step_px));
  if (overlap.covisible_share < 0.005) return std::nullopt;
  return overlap;
}

}  // namespace

double CovisibleShare(const Camera& camera, const DepthView& a, const DepthView& b, int step_px) {
  const Rigid3 b_from_a = Inverse(b.world_from_camera) * a.world_from_camera;
  int shared = 0;
  for (int row = 0; row < a.depth_m.rows; ++row) {
    for (int col = 0; col < a.depth_m.cols; ++col) {
      const double depth = a.depth_m.at<float>(row, col);
      const Eigen::Vector2d x_px(col * step_px + step_px / 2, row * step_px + step_px / 2);
      // Half a sample is far coarser than the lens distortion; a pinhole serves here.
      const Eigen::Vector3d x_in_a((x_px.x() - camera.cx) / camera.fx * depth,
                                   (x_px.y() - camera.cy) / camera.fy * depth, depth);
      if (depth > 0.0 && Sees(camera, b_from_a * x_in_a, b.depth_m, step_px)) ++shared;
    }
  }
  return static_cast<double>(shared) / std::max(a.depth_m.rows * a.depth_m.cols, 1);
}

std::vector<ViewOverlap> FindOverlaps(const Camera& camera, const std::vector<DepthView>& views,
                                      int step_px) {
  std::vector<ViewOverlap> overlaps;
  for (size_t i = 0; i < views.size(); ++i) {
    for (size_t k = i + 1; k < views.size(); ++k) {
      auto overlap = Compare(camera, views[i], views[k], step_px);
      if (!overlap) continue;
      overlap->first = static_cast<int>(i);
      overlap->second = static_cast<int>(k);
      overlaps.push_back(*overlap);
    }
  }
  return overlaps;
}

std::vector<ViewOverlap> FindOverlaps(const Camera& camera, const std::vector<DepthView>& views,
                                      const std::vector<DepthView>& others, int step_px) {
  std::vector<ViewOverlap> overlaps;
  for (size_t i = 0; i < views.size(); ++i) {
    for (size_t k = 0; k < others.size(); ++k) {
      auto overlap = Compare(camera, views[i], others[k], step_px);
      if (!overlap) continue;
      overlap->first = static_cast<int>(i);
      overlap->second = static_cast<int>(k);
      overlaps.push_back(*overlap);
    }
  }
  return overlaps;
}

}  // namespace rovio_sfm::sim
