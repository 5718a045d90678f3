#include "rovio_sfm/sim/world/lens_table.h"

#include <cmath>
#include <stdexcept>

namespace rovio_sfm::sim {

LensTable::LensTable(const Camera& camera) : cols_(camera.width + 1) {
  corners_.reserve(static_cast<size_t>(cols_) * static_cast<size_t>(camera.height + 1));
  for (int row = 0; row <= camera.height; ++row) {
    for (int col = 0; col <= camera.width; ++col) {
      const auto x = NormalizedFromPixel(camera, Eigen::Vector2d(col - 0.5, row - 0.5));
      if (!x) throw std::runtime_error("camera: the distortion cannot be inverted in the image");
      corners_.push_back(x->cast<float>());
    }
  }
}

Eigen::Vector3f LensTable::Direction(float x_px, float y_px) const {
  const float x = x_px + 0.5f, y = y_px + 0.5f;
  const int rows = static_cast<int>(corners_.size()) / cols_;
  const int x0 = std::min(static_cast<int>(x), cols_ - 2);
  const int y0 = std::min(static_cast<int>(y), rows - 2);
  const float a = x - static_cast<float>(x0), b = y - static_cast<float>(y0);
  const Eigen::Vector2f* p = corners_.data() + static_cast<ptrdiff_t>(y0) * cols_ + x0;
  const Eigen::Vector2f direction =
      (1 - b) * ((1 - a) * p[0] + a * p[1]) + b * ((1 - a) * p[cols_] + a * p[cols_ + 1]);
  return {direction.x(), direction.y(), 1.0f};
}

}  // namespace rovio_sfm::sim
