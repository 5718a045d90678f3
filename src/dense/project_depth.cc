#include "rovio_sfm/dense/project_depth.h"

#include <cmath>

namespace rovio_sfm {

Eigen::Vector3d PointOfPixel(const DepthView& view, const Eigen::Vector2d& x_px, double depth) {
  const Eigen::Matrix3d& k = view.pixel_from_ray;
  const Eigen::Vector3d ray((x_px.x() - k(0, 2)) / k(0, 0), (x_px.y() - k(1, 2)) / k(1, 1), 1.0);
  return Inverse(view.cam_from_map) * (depth * ray);
}

std::optional<SeenPoint> SeePoint(const DepthView& view, const Eigen::Vector3d& x_in_map) {
  const Eigen::Vector3d x_in_cam = view.cam_from_map * x_in_map;
  if (!(x_in_cam.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d x_px = (view.pixel_from_ray * x_in_cam).hnormalized();
  if (!(x_px.x() > -0.5 && x_px.x() < view.grey.cols - 0.5 && x_px.y() > -0.5 &&
        x_px.y() < view.grey.rows - 0.5)) {
    return std::nullopt;
  }
  const cv::Point pixel(static_cast<int>(std::lround(x_px.x())),
                        static_cast<int>(std::lround(x_px.y())));
  return SeenPoint{x_px, x_in_cam.z(), pixel};
}

}  // namespace rovio_sfm
