#include "rovio_sfm/io/colmap_camera.h"

namespace rovio_sfm {
namespace {

// As COLMAP numbers them.
constexpr int kPinhole = 1, kOpenCv = 4, kFullOpenCv = 6;

}  // namespace

ColmapCamera ToColmapCamera(const Camera& c) {
  const double cx = c.cx + kColmapPixelCentre, cy = c.cy + kColmapPixelCentre;
  if (c.k3 != 0.0) {
    return {kFullOpenCv,
            "FULL_OPENCV",
            {c.fx, c.fy, cx, cy, c.k1, c.k2, c.p1, c.p2, c.k3, 0.0, 0.0, 0.0}};
  }
  if (c.k1 != 0.0 || c.k2 != 0.0 || c.p1 != 0.0 || c.p2 != 0.0) {
    return {kOpenCv, "OPENCV", {c.fx, c.fy, cx, cy, c.k1, c.k2, c.p1, c.p2}};
  }
  return {kPinhole, "PINHOLE", {c.fx, c.fy, cx, cy}};
}

}  // namespace rovio_sfm
