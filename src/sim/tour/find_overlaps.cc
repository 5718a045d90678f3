#include "rovio_sfm/sim/tour/find_overlaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "rovio_sfm/sim/world/render_image.h"

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

// The point that a's sample shows, in a. Half a sample is far coarser than the lens distortion; a
// pinhole serves here.
Eigen::Vector3d PointOf(const Camera& camera, double depth_m, const Eigen::Vector2d& x_px) {
  return {(x_px.x() - camera.cx) / camera.fx * depth_m,
          (x_px.y() - camera.cy) / camera.fy * depth_m, depth_m};
}

Eigen::Vector2d PixelOfSample(int row, int col, int step_px) {
  return {col * step_px + step_px / 2, row * step_px + step_px / 2};
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

std::vector<DepthView> RenderDepths(const World& world, const Camera& camera,
                                    const SimulatedTour& tour, int step_px) {
  std::vector<DepthView> views;
  for (const TourFrame& frame : tour.frames) {
    views.push_back(
        {frame.world_from_camera, RenderDepth(world, camera, frame.world_from_camera, step_px)});
  }
  return views;
}

std::vector<double> FlowsBetween(const Camera& camera, const DepthView& a, const DepthView& b,
                                 int step_px) {
  const Rigid3 b_from_a = Inverse(b.world_from_camera) * a.world_from_camera;
  std::vector<double> flows_px;
  for (int row = 0; row < a.depth_m.rows; ++row) {
    for (int col = 0; col < a.depth_m.cols; ++col) {
      const double depth_m = a.depth_m.at<float>(row, col);
      const Eigen::Vector2d x_px = PixelOfSample(row, col, step_px);
      const Eigen::Vector3d x_in_b = b_from_a * PointOf(camera, depth_m, x_px);
      if (depth_m <= 0.0 || !Sees(camera, x_in_b, b.depth_m, step_px)) continue;
      const Eigen::Vector2d moved_px(camera.fx * x_in_b.x() / x_in_b.z() + camera.cx,
                                     camera.fy * x_in_b.y() / x_in_b.z() + camera.cy);
      flows_px.push_back((moved_px - x_px).norm());
    }
  }
  std::sort(flows_px.begin(), flows_px.end());
  return flows_px;
}

double CovisibleShare(const Camera& camera, const DepthView& a, const DepthView& b, int step_px) {
  const size_t shared = FlowsBetween(camera, a, b, step_px).size();
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
