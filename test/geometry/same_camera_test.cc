#include "rovio_sfm/geometry/same_camera.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(IsSameCamera, AllowsForRounding) {
  const Camera camera = Camera{520.9, 521.0, 325.1, 249.7, 0.2, -0.7, 0.001, 0.002, 0.9, 640, 480};
  Camera other = camera;
  other.cx += 0.9e-6 * camera.MeanFocal();
  other.k1 -= 0.9e-6;
  EXPECT_TRUE(IsSameCamera(camera, other));
  other.k1 = camera.k1 + 1.1e-6;
  EXPECT_FALSE(IsSameCamera(camera, other));
  other = camera;
  other.fy += 1.1e-6 * camera.MeanFocal();
  EXPECT_FALSE(IsSameCamera(camera, other));
  other = camera;
  ++other.width;
  EXPECT_FALSE(IsSameCamera(camera, other));
}

}  // namespace
}  // namespace rovio_sfm
