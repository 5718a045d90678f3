#include "rovio_sfm/sim/world/surface.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TEST(BuildSurfaces, MakesSixFacesForABoxAndOneForALamp) {
  EXPECT_EQ(BuildSurfaces(SmallWorldSpec()).size(), 5u + 2u * 6u + 1u);
}

TEST(BuildSurfaces, GivesCopiesTheSameTexture) {
  const std::vector<Surface> surfaces = BuildSurfaces(SmallWorldSpec());
  for (size_t face = 5; face < 11; ++face) {
    for (size_t corner = 0; corner < 4; ++corner) {
      EXPECT_EQ(surfaces[face].texels[corner], surfaces[face + 6].texels[corner]);
    }
  }
}

TEST(BuildSurfaces, TurnsNormalsOutwards) {
  const std::vector<Surface> surfaces = BuildSurfaces(SmallWorldSpec());
  const Eigen::Vector3f middle(2.0f, 1.0f, 0.2f);
  for (size_t face = 5; face < 11; ++face) {
    const Eigen::Vector3f on_face = Interpolate(surfaces[face].corners, 0.5f, 0.5f);
    EXPECT_GT(surfaces[face].normals[0].dot(on_face - middle), 0.1f);
  }
}

TEST(BuildSurfaces, RefusesAFaceLargerThanItsTexture) {
  WorldSpec world = SmallWorldSpec();
  world.objects[1].parts[0].size_m = {1.0, 1.0, 1.0};
  EXPECT_THROW(BuildSurfaces(world), std::runtime_error);
}

TEST(BuildSurfaces, ClosesALathe) {
  WorldSpec world = SmallWorldSpec();
  PartSpec& part = world.objects[1].parts[0];
  part.shape = PartShape::kLathe;
  part.profile_m = {{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.2}, {0.0, 0.2}};
  part.sides = 12;
  EXPECT_EQ(BuildSurfaces(world).size(), 5u + 2u * 3u * 12u + 1u);
}

}  // namespace
}  // namespace rovio_sfm::sim
