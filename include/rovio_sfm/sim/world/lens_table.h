#pragma once

#include <Eigen/Core>
#include <vector>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm::sim {

// Undistorted directions of a camera's pixels, tabulated at pixel corners; between them it
// interpolates (error below 1e-4 px for lenses such as the Rovio's).
class LensTable {
 public:
  // Throws std::runtime_error where the distortion cannot be inverted.
  explicit LensTable(const Camera& camera);

  // The direction (x, y, 1) in the camera of a raw pixel position; (0, 0) is the centre of the
  // upper left pixel, valid from -0.5 to size - 0.5.
  Eigen::Vector3f Direction(float x_px, float y_px) const;

 private:
  int cols_;
  std::vector<Eigen::Vector2f> corners_;
};

}  // namespace rovio_sfm::sim
