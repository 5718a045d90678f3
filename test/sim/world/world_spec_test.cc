#include "rovio_sfm/sim/world/world_spec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TEST(WorldSpec, AcceptsTheSmallWorld) {
  std::string error;
  EXPECT_TRUE(SmallWorldSpec().IsValid(&error)) << error;
}

TEST(WorldSpec, NamesAnObjectWithAnUnknownTexture) {
  WorldSpec world = SmallWorldSpec();
  world.objects[1].parts[0].texture = "marble";
  std::string error;
  EXPECT_FALSE(world.IsValid(&error));
  EXPECT_NE(error.find("crate"), std::string::npos);
  EXPECT_NE(error.find("marble"), std::string::npos);
}

TEST(WorldSpec, RefusesTwoTexturesOfOneName) {
  WorldSpec world = SmallWorldSpec();
  world.textures[1].name = "wall";
  std::string error;
  EXPECT_FALSE(world.IsValid(&error));
}

TEST(InLight, DrawsEveryLightWithinAStop) {
  const WorldSpec world = SmallWorldSpec();
  ASSERT_FALSE(world.lights.empty());
  EXPECT_EQ(InLight(world, 0).lights[0].radiance, world.lights[0].radiance);
  for (uint64_t time_of_day = 1; time_of_day < 20; ++time_of_day) {
    const double change = InLight(world, time_of_day).lights[0].radiance / world.lights[0].radiance;
    EXPECT_NE(change, 1.0);
    EXPECT_LE(std::abs(std::log2(change)), 1.0);
  }
}

TEST(WorldSpec, RefusesALatheWithOddSides) {
  WorldSpec world = SmallWorldSpec();
  PartSpec& part = world.objects[1].parts[0];
  part.shape = PartShape::kLathe;
  part.profile_m = {{0.1, 0.0}, {0.1, 1.0}};
  part.sides = 9;
  std::string error;
  EXPECT_FALSE(world.IsValid(&error));
}

}  // namespace
}  // namespace rovio_sfm::sim
