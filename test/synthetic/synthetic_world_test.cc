#include "synthetic/synthetic_world.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace rovio_sfm {
namespace {

TEST(SyntheticWorld, ViewsAreExactProjectionsWithoutNoise) {
  for (const auto scene : {SyntheticScene::kVolume, SyntheticScene::kPlane}) {
    SyntheticOptions options;
    options.scene = scene;
    options.num_cams = 4;
    const SyntheticWorld world = MakeSyntheticWorld(options);
    for (size_t cam = 0; cam < 4; ++cam) {
      EXPECT_GT(world.views[cam].size(), 200u);
      for (const SyntheticView& view : world.views[cam]) {
        const Eigen::Vector3d x_in_cam = world.cams_from_map[cam] * world.points[view.point];
        EXPECT_LT((x_in_cam.hnormalized() - view.x_normalized).norm(), 1e-12);
      }
    }
  }
}

TEST(SyntheticWorld, IsTheSameForTheSameSeed) {
  SyntheticOptions options;
  options.noise_px = 1.0;
  const SyntheticWorld a = MakeSyntheticWorld(options), b = MakeSyntheticWorld(options);
  ASSERT_EQ(a.views[1].size(), b.views[1].size());
  EXPECT_EQ(a.views[1][7].x_px, b.views[1][7].x_px);
  options.seed = 2;
  EXPECT_NE(a.points[0], MakeSyntheticWorld(options).points[0]);
}

TEST(SyntheticWorld, NoiseHasItsStandardDeviation) {
  SyntheticOptions options;
  options.noise_px = 2.0;
  const SyntheticWorld world = MakeSyntheticWorld(options);
  double sum = 0.0;
  for (const SyntheticView& view : world.views[0]) {
    const Eigen::Vector3d x_in_cam = world.cams_from_map[0] * world.points[view.point];
    sum += (x_in_cam.hnormalized() - view.x_normalized).squaredNorm();
  }
  const double sigma = std::sqrt(sum / (2.0 * static_cast<double>(world.views[0].size())));
  EXPECT_NEAR(sigma * world.camera.MeanFocal(), 2.0, 0.2);
}

TEST(SyntheticWorld, MotionsAreWhatTheySay) {
  SyntheticOptions options;
  options.motion = SyntheticMotion::kRotation;
  const SyntheticWorld turning = MakeSyntheticWorld(options);
  EXPECT_LT(OriginInA(turning.cams_from_map[1]).norm(), 1e-12);
  EXPECT_NEAR(RotationAngle(turning.cams_from_map[1].rotation), options.turn_rad, 1e-12);
  options.motion = SyntheticMotion::kForward;
  EXPECT_NEAR(OriginInA(MakeSyntheticWorld(options).cams_from_map[1]).norm(), options.step, 1e-12);
  options.motion = SyntheticMotion::kCircle;
  const Eigen::Vector3d middle(0, 0, options.depth);
  const Rigid3 on_circle = MakeSyntheticWorld(options).cams_from_map[1];
  EXPECT_LT((on_circle * middle - middle).norm(), 1e-12);
}

TEST(SyntheticWorld, PlanarSceneLiesOnAPlane) {
  SyntheticOptions options;
  options.scene = SyntheticScene::kPlane;
  const SyntheticWorld world = MakeSyntheticWorld(options);
  const Eigen::Vector3d normal =
      (world.points[1] - world.points[0]).cross(world.points[2] - world.points[0]).normalized();
  for (const Eigen::Vector3d& point : world.points) {
    EXPECT_NEAR(normal.dot(point - world.points[0]), 0.0, 1e-9);
  }
}

TEST(SyntheticWorld, MatchesHaveTheAskedShareOfOutliers) {
  const SyntheticWorld world = MakeSyntheticWorld({});
  for (const FeatureMatch& match : TrueMatches(world, 0, 1)) {
    EXPECT_TRUE(IsTrueMatch(world, 0, 1, match));
  }
  Rng rng(4);
  const auto matches = MatchesWithOutliers(world, 0, 1, 0.5, rng);
  int num_false = 0;
  for (const FeatureMatch& match : matches) num_false += IsTrueMatch(world, 0, 1, match) ? 0 : 1;
  EXPECT_NEAR(num_false / static_cast<double>(matches.size()), 0.5, 0.02);
}

TEST(SyntheticWorld, FeaturesCarryPixelAndNormalisedPoint) {
  const SyntheticWorld world = MakeSyntheticWorld({});
  const FrameFeatures features = MakeFeatures(world, 1);
  ASSERT_EQ(features.keypoints.size(), world.views[1].size());
  const Keypoint& keypoint = features.keypoints[3];
  const auto back = NormalizedFromPixel(world.camera, {keypoint.x_px, keypoint.y_px});
  ASSERT_TRUE(back);
  EXPECT_LT((*back - keypoint.x_normalized).norm(), 1e-6);
}

TEST(TransformWorld, KeepsWhatTheCamerasSee) {
  const SyntheticWorld world = MakeSyntheticWorld({});
  const Sim3 b_from_a{2.5, Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized(), {3, -2, 1}};
  const SyntheticWorld moved = TransformWorld(b_from_a, world);
  for (const SyntheticView& view : moved.views[1]) {
    const Eigen::Vector3d x_in_cam = moved.cams_from_map[1] * moved.points[view.point];
    EXPECT_LT((x_in_cam.hnormalized() - view.x_normalized).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace rovio_sfm
