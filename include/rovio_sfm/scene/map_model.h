#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// A registered keyframe with all its features, whether or not they see a point of the model.
struct ModelImage {
  FrameId id;
  int64_t stamp_ns = 0;
  std::string name;     // of its picture below a folder of pictures; no two have the same
  uint32_t camera = 0;  // index into MapModel::cameras
  Rigid3 cam_from_map;
  std::vector<Keypoint> keypoints;
};

// A feature of an image that sees a point.
struct ModelView {
  uint32_t image = 0;     // index into MapModel::images
  uint32_t keypoint = 0;  // index into its keypoints
};

struct ModelPoint {
  Eigen::Vector3d x_in_map = Eigen::Vector3d::Zero();
  Rgb color{};
  double error_px = 0.0;         // mean reprojection error
  std::vector<ModelView> views;  // by image, one each, two at least
};

// One map as other programs know a reconstruction: what exporters write. The frame is the level
// frame of the map's root session (x forward, z up), as in cloud.ply. Made for an export, then
// gone.
struct MapModel {
  std::string length_unit;         // "metres" or "map units"
  std::vector<Camera> cameras;     // one a drive
  std::vector<ModelImage> images;  // by drive, then by index
  std::vector<ModelPoint> points;
};

}  // namespace rovio_sfm
