#include "rovio_sfm/sim/world/light_map.h"

#include <gtest/gtest.h>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TEST(LightMap, InterpolatesBetweenItsPoints) {
  LightMap map;
  map.cols = map.rows = 2;
  map.irradiance = {0.0f, 1.0f, 2.0f, 3.0f};
  EXPECT_FLOAT_EQ(map.Sample(0.5f, 0.5f), 1.5f);
  EXPECT_FLOAT_EQ(map.Sample(7.0f, 0.0f), 1.0f);
}

TEST(BakeLight, CastsASoftShadowUnderABox) {
  WorldSpec world = SmallWorldSpec();
  world.light_cell_m = 0.1;
  const std::vector<Surface> surfaces = BuildSurfaces(world);
  const RayScene scene(surfaces);
  const LightMap floor = BakeLight(world, surfaces, scene).front();
  const float open = floor.Sample(0.5f, 0.5f);
  const auto uv = [&](float x, float y) {  // of a floor point, from the floor's corners
    const auto& c = surfaces[0].corners;
    const Eigen::Vector3f way = Eigen::Vector3f(x, y, 0.0f) - c[0];
    return std::make_pair(way.dot(c[1] - c[0]) / (c[1] - c[0]).squaredNorm(),
                          way.dot(c[3] - c[0]) / (c[3] - c[0]).squaredNorm());
  };
  const auto [u, v] = uv(2.3f, 0.9f);  // behind the box, seen from the lamp
  EXPECT_LT(floor.Sample(u, v), 0.7f * open);
}

TEST(BakeLight, IsTheSameTwice) {
  const WorldSpec world = SmallWorldSpec();
  const std::vector<Surface> surfaces = BuildSurfaces(world);
  const RayScene scene(surfaces);
  EXPECT_EQ(BakeLight(world, surfaces, scene)[3].irradiance,
            BakeLight(world, surfaces, scene)[3].irradiance);
}

}  // namespace
}  // namespace rovio_sfm::sim
