#include "rovio_sfm/sim/world/ray_scene.h"

#include <gtest/gtest.h>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

class RayScenes : public testing::Test {
 protected:
  const std::vector<Surface> surfaces_ = BuildSurfaces(SmallWorldSpec());
  const RayScene scene_{surfaces_};
};

TEST_F(RayScenes, FindsTheNearestSurface) {
  const RayHit hit = scene_.Trace({1.0f, 1.0f, 0.2f}, {1.0f, 0.0f, 0.0f});
  EXPECT_NEAR(hit.distance, 0.8f, 1e-4f);
  EXPECT_GE(hit.surface, 5);
}

TEST_F(RayScenes, GivesThePlaceOnTheSurface) {
  const Eigen::Vector3f origin(1.0f, 1.1f, 0.25f), direction(1.0f, 0.0f, 0.0f);
  const RayHit hit = scene_.Trace(origin, direction);
  const auto& corners = surfaces_[static_cast<size_t>(hit.surface)].corners;
  const Eigen::Vector3f point = Interpolate(corners, hit.u, hit.v);
  EXPECT_LT((point - (origin + hit.distance * direction)).norm(), 1e-4f);
}

TEST_F(RayScenes, TracesPacketsAsSingleRays) {
  RayPacket rays;
  for (int i = 0; i < RayPacket::kSize; ++i) {
    rays.origins[i] = {0.5f, 1.5f, 0.3f};
    rays.directions[i] =
        Eigen::Vector3f(1.0f, -0.5f + 0.1f * static_cast<float>(i), 0.05f).normalized();
  }
  RayHit hits[RayPacket::kSize];
  scene_.Trace(rays, hits);
  for (int i = 0; i < RayPacket::kSize; ++i) {
    const RayHit single = scene_.Trace(rays.origins[i], rays.directions[i]);
    EXPECT_EQ(hits[i].surface, single.surface);
    EXPECT_NEAR(hits[i].distance, single.distance, 1e-4f);
  }
}

TEST_F(RayScenes, SaysWhatBlocksTheView) {
  EXPECT_TRUE(scene_.IsBlocked({1.0f, 1.0f, 0.2f}, {2.8f, 1.0f, 0.2f}));
  EXPECT_FALSE(scene_.IsBlocked({1.0f, 1.5f, 0.2f}, {2.8f, 1.5f, 0.2f}));
  EXPECT_FALSE(scene_.IsBlocked({1.0f, 1.0f, 0.2f}, {1.0f, 0.0f, 0.0f}, 0.5f));
}

TEST_F(RayScenes, MissesWhereNothingIs) {
  EXPECT_EQ(scene_.Trace({1.5f, 1.5f, 3.0f}, {0.0f, 0.0f, 1.0f}).surface, -1);
}

}  // namespace
}  // namespace rovio_sfm::sim
