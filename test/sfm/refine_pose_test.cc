#include "rovio_sfm/sfm/refine_pose.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld MakeWorld(double noise_px) {
  SyntheticOptions options;
  options.num_points = 150;
  options.noise_px = noise_px;
  return MakeSyntheticWorld(options);
}

std::vector<PoseObservation> ObservationsOf(const SyntheticWorld& world, size_t cam) {
  std::vector<PoseObservation> observations;
  for (const SyntheticView& view : world.views[cam]) {
    observations.push_back(
        {world.points[view.point], view.x_normalized, 1.0 / world.camera.MeanFocal()});
  }
  return observations;
}

TEST(RefinePose, RecoversTheExactPose) {
  const SyntheticWorld world = MakeWorld(0.0);
  Rng rng(1);
  for (int trial = 0; trial < 10; ++trial) {
    const Rigid3 initial = PerturbPose(world.cams_from_map[1], 0.03, 0.1, rng);
    const auto pose = RefinePose(ObservationsOf(world, 1), initial, {});
    ASSERT_TRUE(pose);
    EXPECT_LT(PoseDistance(*pose, world.cams_from_map[1]), 1e-8);
  }
}

TEST(RefinePose, StaysNearTheTruthWithNoise) {
  const SyntheticWorld world = MakeWorld(1.0);
  const auto pose = RefinePose(ObservationsOf(world, 1), world.cams_from_map[0], {});
  ASSERT_TRUE(pose);
  EXPECT_LT(PoseDistance(*pose, world.cams_from_map[1]), 0.01);
}

TEST(RefinePose, BearsOutliersByItsLoss) {
  const SyntheticWorld world = MakeWorld(0.0);
  auto observations = ObservationsOf(world, 1);
  for (size_t i = 0; i < observations.size(); i += 8) observations[i].x_normalized.y() += 0.1;
  const auto robust = RefinePose(observations, world.cams_from_map[1], {20, 1.0});
  const auto squared = RefinePose(observations, world.cams_from_map[1], {20, 0.0});
  ASSERT_TRUE(robust && squared);
  EXPECT_LT(PoseDistance(*robust, world.cams_from_map[1]), 1e-3);
  EXPECT_GT(PoseDistance(*squared, world.cams_from_map[1]), 5e-3);
}

TEST(RefinePose, PassesOverPointsBehindTheCamera) {
  const SyntheticWorld world = MakeWorld(0.0);
  auto observations = ObservationsOf(world, 1);
  observations.push_back({{0, 0, -5}, {0.1, 0.1}, 0.001});
  Rng rng(2);
  const auto pose =
      RefinePose(observations, PerturbPose(world.cams_from_map[1], 0.01, 0.02, rng), {});
  ASSERT_TRUE(pose);
  EXPECT_LT(PoseDistance(*pose, world.cams_from_map[1]), 1e-6);
}

TEST(RefinePose, RefusesTooFewPoints) {
  const SyntheticWorld world = MakeWorld(0.0);
  auto observations = ObservationsOf(world, 1);
  EXPECT_FALSE(RefinePose({}, {}, {}));
  observations.resize(2);
  EXPECT_FALSE(RefinePose(observations, world.cams_from_map[1], {}));
  for (PoseObservation& observation : observations) observation.point.z() = -4.0;
  EXPECT_FALSE(RefinePose(observations, world.cams_from_map[1], {}));
}

TEST(RefinePose, RefusesPointsThatDoNotDetermineAPose) {
  std::vector<PoseObservation> on_one_line, in_one_place;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d point(0.1 * i - 0.5, 0.2, 4.0);
    on_one_line.push_back({point, point.hnormalized(), 0.001});
    in_one_place.push_back({{0.1, 0.2, 4.0}, {0.025, 0.05}, 0.001});
  }
  EXPECT_FALSE(RefinePose(on_one_line, {}, {}));
  EXPECT_FALSE(RefinePose(in_one_place, {}, {}));
}

}  // namespace
}  // namespace rovio_sfm
