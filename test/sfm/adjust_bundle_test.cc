#include "rovio_sfm/sfm/adjust_bundle.h"

#include <gtest/gtest.h>

#include "sfm/synthetic_bundle.h"

namespace rovio_sfm {
namespace {

TEST(AdjustBundle, RecoversTheExactWorldUpToASimilarity) {
  const SyntheticWorld world = MakeWorld(0.0);
  BundleProblem problem = MakeProblem(world);
  Disturb(&problem, 1);
  const BundleReport report = AdjustBundle(&problem, kExact);
  ASSERT_TRUE(report.usable) << report.message;
  EXPECT_LT(report.final_cost, 1e-6 * report.initial_cost);
  EXPECT_LT(ErrorUpToSimilarity(problem, world), 1e-5);
}

TEST(AdjustBundle, RecoversTheScaleToo_WithTwoFixedCameras) {
  const SyntheticWorld world = MakeWorld(0.0);
  BundleProblem problem = MakeProblem(world);
  problem.cameras[0].fixed = problem.cameras[1].fixed = true;
  Disturb(&problem, 2);
  ASSERT_TRUE(AdjustBundle(&problem, kExact).usable);
  for (size_t i = 0; i < world.cams_from_map.size(); ++i) {
    EXPECT_LT(PoseDistance(problem.cameras[i].cam_from_map, world.cams_from_map[i]), 1e-5);
  }
  EXPECT_EQ(problem.cameras[1].cam_from_map.translation, world.cams_from_map[1].translation);
  for (const BundleObservation& o : problem.observations) {
    EXPECT_LT((problem.points[o.point] - world.points[o.point]).norm(), 1e-3);
  }
}

TEST(AdjustBundle, ChangesNothingOnceItIsGivenUp) {
  const SyntheticWorld world = MakeWorld(0.0);
  BundleProblem problem = MakeProblem(world);
  Disturb(&problem, 1);
  const BundleProblem before = problem;
  for (const int wanted : {0, 1, 3}) {  // times that it is asked
    int num_asked = 0;
    BundleOptions options = kExact;
    options.is_given_up = [&] { return ++num_asked > wanted; };
    EXPECT_FALSE(AdjustBundle(&problem, options).usable);
    EXPECT_EQ(num_asked, wanted + 1);
    EXPECT_EQ(problem.points, before.points);
    EXPECT_EQ(problem.cameras[3].cam_from_map.translation,
              before.cameras[3].cam_from_map.translation);
  }
}

TEST(AdjustBundle, EndsAfterTheReprojectionsThatItMayCompute) {
  const SyntheticWorld world = MakeWorld(0.5);
  const auto iterations = [&](double reprojections_of_each, int max_iterations) {
    BundleProblem problem = MakeProblem(world);
    Disturb(&problem, 1);
    BundleOptions options = kExact;
    options.max_iterations = max_iterations;
    options.max_reprojections =
        reprojections_of_each * static_cast<double>(problem.observations.size());
    return AdjustBundle(&problem, options).iterations - 1;  // less the look at the start
  };
  EXPECT_GT(iterations(0.0, 50), 7);
  EXPECT_EQ(iterations(6.0, 50), 6);
  EXPECT_EQ(iterations(1.0, 50), 4);  // a few at least
  EXPECT_EQ(iterations(6.0, 3), 3);
}

TEST(AdjustBundle, SettlesThePointsThatCrawlUnderARobustLoss) {
  const SyntheticWorld world = MakeWorld(1.0, 60);
  BundleProblem crawling = MakeProblem(world);
  for (size_t i = 0; i < crawling.observations.size(); i += 10) {
    crawling.observations[i].x_normalized.x() += 6.0 * crawling.observations[i].sigma;
  }
  Disturb(&crawling, 60);  // the points alone
  BundleProblem settled = crawling;
  BundleOptions options{50, 1.0, 1e-5};
  const BundleReport without = AdjustBundle(&crawling, options);
  options.settle_points = true;
  const BundleReport with = AdjustBundle(&settled, options);
  ASSERT_TRUE(without.usable && with.usable);
  EXPECT_LT(with.iterations, without.iterations);
  EXPECT_LE(with.final_cost, without.final_cost);
}

TEST(AdjustBundle, HoldsTheGaugeByTheFirstCameraAndOneComponent) {
  const SyntheticWorld world = MakeWorld(0.5);
  BundleProblem problem = MakeProblem(world);
  const BundleProblem before = problem;
  ASSERT_TRUE(AdjustBundle(&problem, kExact).usable);
  EXPECT_EQ(problem.cameras[0].cam_from_map.translation,
            before.cameras[0].cam_from_map.translation);
  EXPECT_EQ(problem.cameras[0].cam_from_map.rotation.coeffs(),
            before.cameras[0].cam_from_map.rotation.coeffs());
  const Eigen::Vector3d moved = problem.cameras.back().cam_from_map.translation -
                                before.cameras.back().cam_from_map.translation;
  EXPECT_EQ(moved.cwiseAbs().minCoeff(), 0.0) << moved.transpose();
  EXPECT_GT(moved.norm(), 0.0);
}

TEST(AdjustBundle, HoldsTheScaleByOneComponentWhereOneCameraIsFixed) {
  const SyntheticWorld world = MakeWorld(0.5);
  BundleProblem problem = MakeProblem(world);
  problem.cameras.back().fixed = true;
  const BundleProblem before = problem;
  ASSERT_TRUE(AdjustBundle(&problem, kExact).usable);
  EXPECT_EQ(problem.cameras.back().cam_from_map.translation,
            before.cameras.back().cam_from_map.translation);
  const Eigen::Vector3d moved =
      problem.cameras[0].cam_from_map.translation - before.cameras[0].cam_from_map.translation;
  EXPECT_EQ(moved.cwiseAbs().minCoeff(), 0.0) << moved.transpose();
}

TEST(AdjustBundle, GivesTheSameCostInAnotherGauge) {
  const SyntheticWorld world = MakeWorld(0.5);
  const Sim3 b_from_a{3.0, Eigen::Quaterniond(0.7, 0.2, -0.4, 0.1).normalized(), {5, -2, 9}};
  BundleProblem in_a = MakeProblem(world), in_b = MakeProblem(TransformWorld(b_from_a, world));
  const BundleReport a = AdjustBundle(&in_a, kExact), b = AdjustBundle(&in_b, kExact);
  ASSERT_TRUE(a.usable && b.usable);
  EXPECT_NEAR(a.initial_cost, b.initial_cost, 1e-9 * a.initial_cost);
  EXPECT_NEAR(a.final_cost, b.final_cost, 1e-6 * a.final_cost);
  EXPECT_NEAR(ErrorUpToSimilarity(in_a, world), ErrorUpToSimilarity(in_b, world), 1e-5);
}

TEST(AdjustBundle, StaysNearTheTruthWithNoise) {
  const SyntheticWorld world = MakeWorld(1.0);
  BundleProblem problem = MakeProblem(world);
  Disturb(&problem, 1);
  ASSERT_TRUE(AdjustBundle(&problem, kExact).usable);
  EXPECT_LT(ErrorUpToSimilarity(problem, world), 0.03);
}

TEST(AdjustBundle, TheRobustLossBearsOutliers) {
  const SyntheticWorld world = MakeWorld(0.0);
  BundleProblem robust = MakeProblem(world);
  for (size_t i = 0; i < robust.observations.size(); i += 20) {
    robust.observations[i].x_normalized.x() += 0.1;
  }
  Disturb(&robust, 1);
  BundleProblem squared = robust;
  ASSERT_TRUE(AdjustBundle(&robust, {50, 1.0, 1e-10}).usable);
  ASSERT_TRUE(AdjustBundle(&squared, {50, 0.0, 1e-10}).usable);
  EXPECT_LT(ErrorUpToSimilarity(robust, world), 0.01);
  EXPECT_LT(ErrorUpToSimilarity(robust, world), 0.2 * ErrorUpToSimilarity(squared, world));
}

void ExpectSameBytesTwice(int num_cams) {
  const SyntheticWorld world = MakeWorld(1.0, num_cams);
  BundleProblem a = MakeProblem(world), b = a;
  ASSERT_TRUE(AdjustBundle(&a, {}).usable);
  ASSERT_TRUE(AdjustBundle(&b, {}).usable);
  EXPECT_EQ(Centers(a), Centers(b));
  EXPECT_EQ(a.points, b.points);
}

TEST(AdjustBundle, GivesTheSameBytesTwice_Dense) { ExpectSameBytesTwice(6); }
TEST(AdjustBundle, GivesTheSameBytesTwice_Sparse) { ExpectSameBytesTwice(30); }

TEST(AdjustBundle, RefusesWhatItCannotSolveAndChangesNothing) {
  BundleProblem empty;
  EXPECT_FALSE(AdjustBundle(&empty, {}).usable);
  const SyntheticWorld world = MakeWorld(0.0, 2);
  BundleProblem unseen = MakeProblem(world);
  unseen.observations.clear();
  const BundleReport report = AdjustBundle(&unseen, {});
  EXPECT_FALSE(report.usable);
  EXPECT_FALSE(report.message.empty());
  BundleProblem behind = MakeProblem(world);
  behind.points[behind.observations[0].point] = {0, 0, -3};
  const std::vector<Eigen::Vector3d> points = behind.points;
  EXPECT_FALSE(AdjustBundle(&behind, {}).usable);
  EXPECT_EQ(behind.points, points);
  EXPECT_EQ(Centers(behind), Centers(unseen));
}

}  // namespace
}  // namespace rovio_sfm
