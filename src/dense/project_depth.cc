#include "rovio_sfm/dense/project_depth.h"

#include <Eigen/LU>
#include <cmath>

namespace rovio_sfm {

PixelTransfer TransferPixels(const DepthView& to, const DepthView& from) {
  const Rigid3 to_from_from = to.cam_from_map * Inverse(from.cam_from_map);
  return {
      to.pixel_from_ray * to_from_from.rotation.toRotationMatrix() * from.pixel_from_ray.inverse(),
      to.pixel_from_ray * to_from_from.translation};
}

std::optional<Eigen::Vector2d> PlaceInPicture(const Eigen::Vector3d& transferred,
                                              const cv::Size& size) {
  if (!(transferred.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2d x_px = transferred.hnormalized();
  if (!(x_px.x() > -0.5 && x_px.x() < size.width - 0.5 && x_px.y() > -0.5 &&
        x_px.y() < size.height - 0.5)) {
    return std::nullopt;
  }
  return x_px;
}

cv::Point NearestPixel(const Eigen::Vector2d& x_px) {
  return {static_cast<int>(std::lround(x_px.x())), static_cast<int>(std::lround(x_px.y()))};
}

Eigen::Vector3d RayOfPixel(const DepthView& view, const Eigen::Vector2d& x_px) {
  const Eigen::Matrix3d& k = view.pixel_from_ray;
  return {(x_px.x() - k(0, 2)) / k(0, 0), (x_px.y() - k(1, 2)) / k(1, 1), 1.0};
}

Eigen::Vector3d PointOfPixel(const DepthView& view, const Eigen::Vector2d& x_px, double depth) {
  return Inverse(view.cam_from_map) * (depth * RayOfPixel(view, x_px));
}

std::optional<SeenPoint> SeePoint(const DepthView& view, const Eigen::Vector3d& x_in_map) {
  const Eigen::Vector3d x_in_cam = view.cam_from_map * x_in_map;
  const auto place = PlaceInPicture(view.pixel_from_ray * x_in_cam, view.grey.size());
  if (!place) return std::nullopt;
  return SeenPoint{*place, x_in_cam.z(), NearestPixel(*place)};
}

}  // namespace rovio_sfm
