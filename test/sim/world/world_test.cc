#include "rovio_sfm/sim/world/world.h"

#include <gtest/gtest.h>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TEST(World, SeesTheLampsOwnLight) {
  const World world(SmallWorldSpec());
  const Eigen::Vector3f origin(1.5f, 1.5f, 0.5f), up(0.0f, 0.0f, 1.0f);
  const RayHit hit = world.scene().Trace(origin, up);
  EXPECT_FLOAT_EQ(world.Radiance(origin, up, hit, 0.001f, {0.0f, 0.0f}).x(), 12.0f);
}

TEST(World, SeesTheRoomInTheMirror) {
  const World world(SmallWorldSpec());
  const Eigen::Vector3f origin(1.0f, 1.5f, 1.0f);
  const Eigen::Vector3f to_mirror(1.0f, 0.0f, 0.0f), to_wall(-1.0f, 0.0f, 0.0f);
  const auto look = [&](const Eigen::Vector3f& direction) {
    return world.Radiance(origin, direction, world.scene().Trace(origin, direction), 0.001f,
                          {0.0f, 0.0f});
  };
  EXPECT_NEAR(look(to_mirror).x(), look(to_wall).x(), 0.5f * look(to_wall).x());
  EXPECT_GT(look(to_wall).x(), 0.01f);
}

TEST(World, IsBlackWhereNothingIs) {
  const World world(SmallWorldSpec());
  EXPECT_EQ(world.Radiance({0, 0, 0}, {0, 0, 1}, RayHit{}, 0.001f, {0, 0}).norm(), 0.0f);
}

}  // namespace
}  // namespace rovio_sfm::sim
