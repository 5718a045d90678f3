#include "rovio_sfm/io/colmap_camera.h"

#include "io/synthetic_model.h"

namespace rovio_sfm {
namespace {

TEST(ToColmapCamera, MovesThePrincipalPointByHalfAPixel) {
  const ColmapCamera camera = ToColmapCamera(PlainCamera());
  EXPECT_EQ(camera.model, "PINHOLE");
  EXPECT_EQ(camera.parameters, (std::vector<double>{500.0, 500.0, 320.0, 240.0}));
}

TEST(ToColmapCamera, TakesTheSimplestModelThatHoldsTheDistortion) {
  const Camera full = FullCamera();
  EXPECT_EQ(ToColmapCamera(full).model, "FULL_OPENCV");
  EXPECT_EQ(ToColmapCamera(full).parameters.size(), 12u);
  EXPECT_EQ(ToColmapCamera(full).parameters[8], full.k3);
  Camera without_k3 = full;
  without_k3.k3 = 0.0;
  EXPECT_EQ(ToColmapCamera(without_k3).model, "OPENCV");
  EXPECT_EQ(ToColmapCamera(without_k3).parameters.back(), full.p2);
}

}  // namespace
}  // namespace rovio_sfm
