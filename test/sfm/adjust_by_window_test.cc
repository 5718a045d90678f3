#include "rovio_sfm/sfm/adjust_by_window.h"

#include <gtest/gtest.h>

#include "sfm/synthetic_bundle.h"

namespace rovio_sfm {
namespace {

constexpr int kNumCameras = 30;

TEST(AdjustByWindow, IsAdjustBundleForWhatFitsIntoOneWindow) {
  BundleProblem by_window = MakeProblem(MakeWorld(1.0)), whole = by_window;
  Disturb(&by_window, 1);
  Disturb(&whole, 1);
  const BundleReport a = AdjustByWindow(&by_window, kExact, by_window.cameras.size());
  const BundleReport b = AdjustBundle(&whole, kExact);
  ASSERT_TRUE(a.usable && b.usable);
  EXPECT_EQ(a.final_cost, b.final_cost);
  EXPECT_EQ(Centers(by_window), Centers(whole));
  EXPECT_EQ(by_window.points, whole.points);
}

TEST(AdjustByWindow, MovesNothingThatIsExact) {
  const SyntheticWorld world = MakeWorld(0.0, kNumCameras);
  BundleProblem problem = MakeProblem(world);
  ASSERT_TRUE(AdjustByWindow(&problem, kExact, 8).usable);
  EXPECT_LT(ErrorUpToSimilarity(problem, world), 1e-7);
}

TEST(AdjustByWindow, ComesNearTheWholeAdjustment) {
  const SyntheticWorld world = MakeWorld(1.0, kNumCameras);
  BundleProblem by_window = MakeProblem(world);
  Disturb(&by_window, 1);
  BundleProblem whole = by_window;
  const double before = ErrorUpToSimilarity(by_window, world);
  ASSERT_TRUE(AdjustByWindow(&by_window, {50, 1.0, 1e-8}, 12).usable);
  ASSERT_TRUE(AdjustBundle(&whole, {50, 1.0, 1e-8}).usable);
  EXPECT_LT(ErrorUpToSimilarity(by_window, world), 0.5 * before);
  EXPECT_LT(ErrorUpToSimilarity(by_window, world), 2.0 * ErrorUpToSimilarity(whole, world) + 0.005);
}

TEST(AdjustByWindow, LeavesTheFirstCameraAndAllFixedOnes) {
  BundleProblem problem = MakeProblem(MakeWorld(0.5, kNumCameras));
  problem.cameras[20].fixed = true;
  Disturb(&problem, 0);
  const std::vector<Eigen::Vector3d> before = Centers(problem);
  ASSERT_TRUE(AdjustByWindow(&problem, {}, 8).usable);
  const std::vector<Eigen::Vector3d> after = Centers(problem);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[20], before[20]);
  EXPECT_NE(after[10], before[10]);
  EXPECT_TRUE(problem.cameras[20].fixed);
  EXPECT_FALSE(problem.cameras[0].fixed || problem.cameras[19].fixed);
}

TEST(AdjustByWindow, GivesTheSameBytesTwice) {
  BundleProblem a = MakeProblem(MakeWorld(1.0, kNumCameras)), b = a;
  ASSERT_TRUE(AdjustByWindow(&a, {}, 10).usable);
  ASSERT_TRUE(AdjustByWindow(&b, {}, 10).usable);
  EXPECT_EQ(Centers(a), Centers(b));
  EXPECT_EQ(a.points, b.points);
}

TEST(AdjustByWindow, PassesOverAWindowThatCannotBeSolved) {
  BundleProblem problem = MakeProblem(MakeWorld(0.0, kNumCameras));
  const uint32_t point = problem.observations.front().point;
  problem.points[point] = -problem.points[point] + 2.0 * Centers(problem)[0];
  const Eigen::Vector3d behind = problem.points[point];
  AdjustByWindow(&problem, {}, 8);
  EXPECT_EQ(problem.points[point], behind);

  problem.observations.clear();
  const BundleReport report = AdjustByWindow(&problem, {}, 8);
  EXPECT_FALSE(report.usable);
  EXPECT_FALSE(report.message.empty());
}

}  // namespace
}  // namespace rovio_sfm
