#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

// Where pixels of one view lie in another (half size): pixel (u, v) at a depth is (u' z', v' z',
// z') there.
struct PixelTransfer {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // of what is infinitely far
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector2d& x_px, double depth) const {
    return depth * (turn * x_px.homogeneous()) + shift;
  }
};

PixelTransfer TransferPixels(const DepthView& to, const DepthView& from);

// Where in a picture what was transferred lies; nothing behind the view or outside of the picture.
std::optional<Eigen::Vector2d> PlaceInPicture(const Eigen::Vector3d& transferred,
                                              const cv::Size& size);

cv::Point NearestPixel(const Eigen::Vector2d& x_px);

// Through a pixel (half size), in the view, at depth 1.
Eigen::Vector3d RayOfPixel(const DepthView& view, const Eigen::Vector2d& x_px);

// The point of a pixel (half size) at a depth, in the map.
Eigen::Vector3d PointOfPixel(const DepthView& view, const Eigen::Vector2d& x_px, double depth);

struct SeenPoint {
  Eigen::Vector2d x_px;  // half size
  double depth = 0.0;
  cv::Point pixel;  // the nearest, inside the picture
};

// Where a view would see a point of the map; nothing behind it or outside of its picture.
std::optional<SeenPoint> SeePoint(const DepthView& view, const Eigen::Vector3d& x_in_map);

}  // namespace rovio_sfm
