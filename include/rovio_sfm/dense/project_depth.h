#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

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
