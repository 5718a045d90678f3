#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

constexpr double kColmapPixelCentre = 0.5;  // COLMAP's pixel = ours + this

// A camera as COLMAP knows it.
struct ColmapCamera {
  int model_id = 0;
  std::string model;
  std::vector<double> parameters;  // in the order of the model
};

// The simplest of PINHOLE, OPENCV and FULL_OPENCV that holds the camera.
ColmapCamera ToColmapCamera(const Camera& camera);

}  // namespace rovio_sfm
