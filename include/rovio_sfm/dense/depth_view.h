#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// A picture as the sweep sees it: without distortion, at half size.
struct DepthView {
  cv::Mat grey;                                                  // CV_8U
  cv::Mat bgr;                                                   // CV_8UC3, the same size
  Eigen::Matrix3d pixel_from_ray = Eigen::Matrix3d::Identity();  // pinhole, of the half size
  Rigid3 cam_from_map;
  double near = 0.0, far = 0.0;     // range of depths to look in, map units
  double typical = 0.0;             // median depth of the landmarks that it sees, map units
  std::vector<uint32_t> neighbors;  // views that see the same from aside, the best first
};

// Depth along the optical axis in map units (CV_32F), 0 where it is not known.
using DepthMap = cv::Mat;

// A depth map and how well it is measured: how far a depth moves (map units, CV_32F) with an error
// of one pixel.
struct MeasuredDepth {
  DepthMap depth;
  cv::Mat sigma;
};

// Decodes a picture of the camera for the sweep. Throws std::runtime_error where the bytes are no
// picture of the camera's size. Pose, range and neighbours are left to the caller.
DepthView MakeDepthView(const std::vector<uint8_t>& encoded, const Camera& camera);

}  // namespace rovio_sfm
