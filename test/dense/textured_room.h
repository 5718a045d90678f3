#pragma once

#include <Eigen/Geometry>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

inline Camera SmallCamera() {
  Camera camera;
  camera.fx = camera.fy = 300.0;
  camera.cx = 159.5, camera.cy = 119.5;
  camera.width = 320, camera.height = 240;
  return camera;
}

// A textured wall at z = depth, seen by a camera at (x, y, 0) that looks along z; a texel is 1 cm.
inline cv::Mat SeeWall(double x, double y, double depth, int contrast = 60) {
  cv::Mat texture(600, 600, CV_8UC3);
  cv::RNG rng(7);
  rng.fill(texture, cv::RNG::UNIFORM, 128 - contrast, 128 + contrast);
  cv::GaussianBlur(texture, texture, {}, 1.5);
  const Camera camera = SmallCamera();
  // Texel (u, v) is the point ((u - 300) / 100, (v - 300) / 100, depth).
  const double scale = camera.fx / (100.0 * depth);
  const cv::Matx23d picture_from_texture(
      scale, 0.0, camera.cx - camera.fx * x / depth - 300.0 * scale,  //
      0.0, scale, camera.cy - camera.fy * y / depth - 300.0 * scale);
  cv::Mat picture;
  cv::warpAffine(texture, picture, picture_from_texture, {camera.width, camera.height},
                 cv::INTER_AREA);
  return picture;
}

inline DepthView ViewOfWall(double x, double y, double depth, int contrast = 60) {
  std::vector<uint8_t> png;
  cv::imencode(".png", SeeWall(x, y, depth, contrast), png);
  DepthView view = MakeDepthView(png, SmallCamera());
  view.cam_from_map.translation = {-x, -y, 0.0};
  view.near = 0.5 * depth, view.far = 2.0 * depth;
  return view;
}

// Five views of one wall, 20 cm apart; each has the others as neighbours.
inline std::vector<DepthView> ViewsOfWall(double depth) {
  std::vector<DepthView> views;
  for (const auto& [x, y] :
       {std::pair{0.0, 0.0}, {0.2, 0.0}, {-0.2, 0.0}, {0.0, 0.2}, {0.0, -0.2}}) {
    views.push_back(ViewOfWall(x, y, depth));
  }
  for (uint32_t i = 0; i < views.size(); ++i) {
    for (uint32_t j = 0; j < views.size(); ++j) {
      if (j != i) views[i].neighbors.push_back(j);
    }
  }
  return views;
}

inline DepthMap Constant(const DepthView& view, float depth) {
  return DepthMap(view.grey.size(), CV_32F, cv::Scalar(depth));
}

inline std::vector<const DepthView*> NeighborsOf(const std::vector<DepthView>& views, size_t view) {
  std::vector<const DepthView*> neighbors;
  for (const uint32_t other : views[view].neighbors) neighbors.push_back(&views[other]);
  return neighbors;
}

}  // namespace rovio_sfm
