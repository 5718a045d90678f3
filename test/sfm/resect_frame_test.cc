#include "rovio_sfm/sfm/resect_frame.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld MakeWorld(double noise_px, SyntheticScene scene = SyntheticScene::kVolume) {
  SyntheticOptions options;
  options.num_points = 200;
  options.scene = scene;
  options.noise_px = noise_px;
  return MakeSyntheticWorld(options);
}

std::vector<PoseObservation> ObservationsOf(const SyntheticWorld& world) {
  std::vector<PoseObservation> observations;
  for (const SyntheticView& view : world.views[1]) {
    observations.push_back(
        {world.points[view.point], view.x_normalized, 1.0 / world.camera.MeanFocal()});
  }
  return observations;
}

// Every third observation looks elsewhere.
std::vector<PoseObservation> WithOutliers(std::vector<PoseObservation> observations, Rng& rng) {
  for (size_t i = 0; i < observations.size(); i += 3) {
    const double x = rng.Uniform(-0.5, 0.5), y = rng.Uniform(-0.4, 0.4);
    observations[i].x_normalized = {x, y};
  }
  return observations;
}

TEST(ResectFrame, RecoversTheExactPose) {
  for (const auto scene : {SyntheticScene::kVolume, SyntheticScene::kPlane}) {
    const SyntheticWorld world = MakeWorld(0.0, scene);
    const auto observations = ObservationsOf(world);
    Rng rng(1);
    const auto resection = ResectFrame(observations, {}, rng);
    ASSERT_TRUE(resection);
    EXPECT_LT(PoseDistance(resection->cam_from_map, world.cams_from_map[1]), 1e-7);
    EXPECT_EQ(resection->inliers.size(), observations.size());
  }
}

TEST(ResectFrame, FindsTheInliersAmongOutliers) {
  const SyntheticWorld world = MakeWorld(1.0);
  Rng rng(2);
  const auto observations = WithOutliers(ObservationsOf(world), rng);
  const auto resection = ResectFrame(observations, {}, rng);
  ASSERT_TRUE(resection);
  EXPECT_LT(PoseDistance(resection->cam_from_map, world.cams_from_map[1]), 0.02);
  EXPECT_GT(resection->inliers.size(), observations.size() / 2);
  EXPECT_TRUE(std::is_sorted(resection->inliers.begin(), resection->inliers.end()));
  size_t num_false = 0;
  for (const uint32_t i : resection->inliers) num_false += i % 3 == 0 ? 1 : 0;
  EXPECT_LE(num_false, 2u);
}

TEST(ResectFrame, IsTheSameForTheSameSeed) {
  const SyntheticWorld world = MakeWorld(1.0);
  Rng rng(3);
  const auto observations = WithOutliers(ObservationsOf(world), rng);
  Rng a(4), b(4);
  const auto first = ResectFrame(observations, {}, a), second = ResectFrame(observations, {}, b);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->cam_from_map.translation, second->cam_from_map.translation);
  EXPECT_EQ(first->inliers, second->inliers);
}

TEST(ResectFrame, RefusesTooFewAndContradictingObservations) {
  const SyntheticWorld world = MakeWorld(0.0);
  Rng rng(5);
  EXPECT_FALSE(ResectFrame({}, {}, rng));
  auto observations = ObservationsOf(world);
  auto few = observations;
  few.resize(5);
  EXPECT_FALSE(ResectFrame(few, {}, rng));
  observations.resize(30);
  for (PoseObservation& observation : observations) {
    const double x = rng.Uniform(-0.5, 0.5), y = rng.Uniform(-0.4, 0.4);
    observation.x_normalized = {x, y};
  }
  EXPECT_FALSE(ResectFrame(observations, {}, rng));
}

TEST(ResectFrame, RefusesPointsOnOneLine) {
  std::vector<PoseObservation> on_one_line;
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d point(0.05 * i - 1.0, 0.2, 4.0);
    on_one_line.push_back({point, point.hnormalized(), 0.001});
  }
  Rng rng(6);
  EXPECT_FALSE(ResectFrame(on_one_line, {}, rng));
}

TEST(ResectFromPrediction, RecoversTheExactPoseFromANearOne) {
  const SyntheticWorld world = MakeWorld(0.0);
  const auto resection = ResectFromPrediction(ObservationsOf(world), world.cams_from_map[0], {});
  ASSERT_TRUE(resection);
  EXPECT_LT(PoseDistance(resection->cam_from_map, world.cams_from_map[1]), 1e-7);
}

TEST(ResectFromPrediction, RefusesWhereNothingAgrees) {
  const SyntheticWorld world = MakeWorld(0.0);
  EXPECT_FALSE(ResectFromPrediction({}, world.cams_from_map[0], {}));
  const Rigid3 looking_back{Eigen::Quaterniond(0, 0, 1, 0), {0, 0, 0}};
  EXPECT_FALSE(ResectFromPrediction(ObservationsOf(world), looking_back, {}));
}

}  // namespace
}  // namespace rovio_sfm
