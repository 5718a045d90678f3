#include "rovio_sfm/sim/world/read_placement.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(ReadPlacement, TurnsByYaw) {
  YamlMap map(YAML::Load("{at_m: [1, 2, 3], yaw_deg: 90}"), "here");
  const Rigid3 placement = ReadPlacement(&map);
  const Eigen::Vector3d moved = placement * Eigen::Vector3d(1, 0, 0);
  EXPECT_NEAR((moved - Eigen::Vector3d(1, 3, 3)).norm(), 0.0, 1e-12);
  EXPECT_NO_THROW(map.RefuseUnknownKeys());
}

TEST(ReadPlacement, IsNowhereElseWithoutKeys) {
  YamlMap map(YAML::Node(), "here");
  const Rigid3 placement = ReadPlacement(&map);
  EXPECT_EQ(placement.translation, Eigen::Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace rovio_sfm::sim
