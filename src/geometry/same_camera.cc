#include "rovio_sfm/geometry/same_camera.h"

#include <cmath>

namespace rovio_sfm {
namespace {

constexpr double kSameShare = 1e-6;  // of the focal length

}  // namespace

bool IsSameCamera(const Camera& a, const Camera& b) {
  const auto is_near = [](double x, double y, double unit) {
    return std::abs(x - y) <= kSameShare * unit;
  };
  const double focal_px = a.MeanFocal();
  return a.width == b.width && a.height == b.height && is_near(a.fx, b.fx, focal_px) &&
         is_near(a.fy, b.fy, focal_px) && is_near(a.cx, b.cx, focal_px) &&
         is_near(a.cy, b.cy, focal_px) && is_near(a.k1, b.k1, 1.0) && is_near(a.k2, b.k2, 1.0) &&
         is_near(a.p1, b.p1, 1.0) && is_near(a.p2, b.p2, 1.0) && is_near(a.k3, b.k3, 1.0);
}

}  // namespace rovio_sfm
