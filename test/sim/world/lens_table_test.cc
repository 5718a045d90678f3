#include "rovio_sfm/sim/world/lens_table.h"

#include <gtest/gtest.h>

#include "rovio_sfm/sim/robot/robot_body.h"

namespace rovio_sfm::sim {
namespace {

TEST(LensTable, InvertsTheRoviosLens) {
  const Camera camera = RovioCamera();
  const LensTable lens(camera);
  for (const Eigen::Vector2d& x_px :
       {Eigen::Vector2d(0.3, 0.7), Eigen::Vector2d(320.4, 200.9), Eigen::Vector2d(639.2, 479.4),
        Eigen::Vector2d(-0.5, 100.0)}) {
    const Eigen::Vector3f ray =
        lens.Direction(static_cast<float>(x_px.x()), static_cast<float>(x_px.y()));
    const Eigen::Vector2d back = PixelFromNormalized(camera, ray.head<2>().cast<double>());
    EXPECT_LT((back - x_px).norm(), 1e-3) << x_px.transpose();
  }
}

}  // namespace
}  // namespace rovio_sfm::sim
