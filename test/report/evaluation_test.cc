#include "rovio_sfm/report/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

constexpr int64_t kStepNs = 33'000'000;

// A helix, looking along its tangent, at 30 Hz.
std::vector<StampedPose> Helix(int count) {
  std::vector<StampedPose> trajectory;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.05 * i;
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
    trajectory.push_back({i * kStepNs, {rotation, {std::cos(angle), std::sin(angle), 0.01 * i}}});
  }
  return trajectory;
}

// The same trajectory in another gauge: map_from_camera for a map of half the size, turned.
std::vector<StampedPose> InMap(const std::vector<StampedPose>& truth) {
  Sim3 map_from_world;
  map_from_world.scale = 0.5;
  map_from_world.rotation = Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized());
  map_from_world.translation = {4.0, 5.0, 6.0};
  std::vector<StampedPose> poses = truth;
  for (StampedPose& pose : poses) {
    pose.reference_from_body = {map_from_world.rotation * pose.reference_from_body.rotation,
                                map_from_world * pose.reference_from_body.translation};
  }
  return poses;
}

TEST(EvaluateTrajectories, FindsNoErrorInAnotherGauge) {
  const auto truth = Helix(100);
  const auto report = EvaluateTrajectories({{InMap(truth), truth}});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->num_compared, 100u);
  EXPECT_NEAR(report->ate_rmse_m, 0.0, 1e-9);
  EXPECT_NEAR(report->rotation_rmse_deg, 0.0, 1e-5);
  EXPECT_NEAR(report->world_from_map.scale, 2.0, 1e-9);
  EXPECT_NEAR(report->scale_error, 1.0, 1e-9);
  ASSERT_TRUE(report->rpe_rmse_m.has_value());
  EXPECT_NEAR(*report->rpe_rmse_m, 0.0, 1e-9);
  EXPECT_NEAR(report->path_length_m, 99 * std::hypot(2.0 * std::sin(0.025), 0.01), 1e-9);
}

TEST(EvaluateTrajectories, SetsTheRollOfAStraightPathApart) {
  std::vector<StampedPose> truth, estimate;
  for (int i = 0; i < 50; ++i) {
    const double sway = 0.002 * (i % 3);
    truth.push_back(
        {i * kStepNs, {Eigen::Quaterniond::Identity(), {0.1 * i, sway, sway * (i % 2)}}});
    estimate.push_back(truth.back());
    const Eigen::Quaterniond rolled(Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitX()));
    const Eigen::Quaterniond pitched(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()));
    estimate.back().reference_from_body.rotation = rolled * pitched;
  }
  const auto report = EvaluateTrajectories({{estimate, truth}});
  ASSERT_TRUE(report.has_value());
  EXPECT_NEAR(report->roll_deg, 0.05 * 180 / M_PI, 1e-2);
  EXPECT_NEAR(report->rotation_rmse_after_roll_deg, 0.01 * 180 / M_PI, 1e-2);
  EXPECT_GT(report->rotation_rmse_deg, 2.8);
}

TEST(EvaluateTrajectories, MeasuresErrorsInMetresAndDegrees) {
  const auto truth = Helix(1000);
  auto estimate = truth;
  estimate[500].reference_from_body.translation.z() += 0.1;
  const Eigen::Quaterniond two_degrees(
      Eigen::AngleAxisd(2.0 * M_PI / 180, Eigen::Vector3d::UnitX()));
  for (StampedPose& pose : estimate) {
    pose.reference_from_body.rotation = pose.reference_from_body.rotation * two_degrees;
  }
  const auto report = EvaluateTrajectories({{estimate, truth}});
  ASSERT_TRUE(report.has_value());
  EXPECT_NEAR(report->ate_max_m, 0.1, 1e-3);
  EXPECT_NEAR(report->ate_rmse_m, 0.1 / std::sqrt(1000.0), 1e-4);
  EXPECT_LT(report->ate_p95_m, 1e-3);
  EXPECT_NEAR(report->rotation_rmse_deg, 2.0, 0.02);
}

TEST(EvaluateTrajectories, LeavesOutAndCountsGaps) {
  const auto truth = Helix(100);
  auto sparse = truth;
  sparse.erase(sparse.begin() + 40, sparse.begin() + 50);
  const auto report = EvaluateTrajectories({{truth, sparse}});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->num_poses, 100u);
  EXPECT_EQ(report->num_compared, 90u);
}

TEST(EvaluateTrajectories, UsesExactStampsHoweverFarApart) {
  auto truth = Helix(10);
  for (size_t i = 0; i < truth.size(); ++i)
    truth[i].stamp_ns = static_cast<int64_t>(i) * 1'000'000'000;
  const auto report = EvaluateTrajectories({{truth, truth}});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->num_compared, 10u);
  EXPECT_EQ(report->num_rpe_pairs, 9u);
}

TEST(EvaluateTrajectories, AlignsAllDrivesAtOnce) {
  const auto truth = Helix(100);
  auto shifted = InMap(truth);
  for (StampedPose& pose : shifted) pose.reference_from_body.translation.x() += 0.5;
  const auto report = EvaluateTrajectories({{InMap(truth), truth}, {shifted, truth}});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->num_compared, 200u);
  EXPECT_GT(report->ate_rmse_m, 0.3);
}

TEST(EvaluateTrajectories, RefusesTooFewPosesAndLines) {
  const auto truth = Helix(2);
  EXPECT_FALSE(EvaluateTrajectories({{truth, truth}}).has_value());
  EXPECT_FALSE(EvaluateTrajectories({}).has_value());
  auto line = Helix(10);
  for (StampedPose& pose : line) {
    pose.reference_from_body.translation = {static_cast<double>(pose.stamp_ns), 0.0, 0.0};
  }
  EXPECT_FALSE(EvaluateTrajectories({{line, line}}).has_value());
}

}  // namespace
}  // namespace rovio_sfm
