#include "rovio_sfm/sfm/reprojection_cost.h"

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

using Pose = Eigen::Matrix<double, kPoseSize, 1>;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kStep = 1e-6;

Eigen::Vector3d AnyVector(Rng& rng) {
  const double x = rng.Uniform(-1, 1), y = rng.Uniform(-1, 1), z = rng.Uniform(-1, 1);
  return {x, y, z};
}

Pose AnyPose(Rng& rng) {
  Pose pose;
  const Eigen::Vector3d turn = 2.0 * AnyVector(rng);
  pose.head<4>() = Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())).coeffs();
  pose.tail<3>() = AnyVector(rng);
  return pose;
}

// A point that lies about two units in front of the camera.
Eigen::Vector3d PointBefore(const Pose& pose, Rng& rng) {
  const Eigen::Quaterniond rotation(pose[3], pose[0], pose[1], pose[2]);
  const Eigen::Vector3d x_in_cam = Eigen::Vector3d(0, 0, 2.5) + AnyVector(rng);
  return rotation.conjugate() * (x_in_cam - pose.tail<3>());
}

Eigen::Vector2d Residual(const ceres::CostFunction& cost, const Pose& pose,
                         const Eigen::Vector3d& point) {
  const double* blocks[] = {pose.data(), point.data()};
  Eigen::Vector2d residual;
  EXPECT_TRUE(cost.Evaluate(blocks, residual.data(), nullptr));
  return residual;
}

Pose Plus(const ceres::Manifold& manifold, const Pose& pose, int component, double step) {
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(manifold.TangentSize());
  delta[component] = step;
  Pose moved;
  EXPECT_TRUE(manifold.Plus(pose.data(), delta.data(), moved.data()));
  return moved;
}

void CheckJacobians(int fixed_component, Rng& rng) {
  const Pose pose = AnyPose(rng);
  const Eigen::Vector3d point = PointBefore(pose, rng);
  const std::unique_ptr<ceres::CostFunction> cost(MakeReprojectionCost({0.1, -0.2}, 0.5));
  const std::unique_ptr<ceres::Manifold> manifold(MakePoseManifold(fixed_component));
  RowMajor by_pose(2, kPoseSize), by_point(2, 3), plus(kPoseSize, manifold->TangentSize());
  const double* blocks[] = {pose.data(), point.data()};
  double* jacobians[] = {by_pose.data(), by_point.data()};
  Eigen::Vector2d residual;
  ASSERT_TRUE(cost->Evaluate(blocks, residual.data(), jacobians));
  ASSERT_TRUE(manifold->PlusJacobian(pose.data(), plus.data()));
  const RowMajor by_tangent = by_pose * plus;
  for (int i = 0; i < manifold->TangentSize(); ++i) {
    const Eigen::Vector2d numeric = (Residual(*cost, Plus(*manifold, pose, i, kStep), point) -
                                     Residual(*cost, Plus(*manifold, pose, i, -kStep), point)) /
                                    (2.0 * kStep);
    EXPECT_LT((numeric - by_tangent.col(i)).norm(), 1e-6) << "tangent " << i;
  }
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const Eigen::Vector2d numeric =
        (Residual(*cost, pose, point + step) - Residual(*cost, pose, point - step)) / (2.0 * kStep);
    EXPECT_LT((numeric - by_point.col(i)).norm(), 1e-6) << "point " << i;
  }
}

TEST(ReprojectionCost, JacobiansAreThoseOfFiniteDifferences) {
  Rng rng(1);
  for (int trial = 0; trial < 20; ++trial) CheckJacobians(trial % 4 - 1, rng);
}

TEST(UncalibratedCost, JacobiansAreThoseOfFiniteDifferences) {
  Rng rng(2);
  const Pose pose = AnyPose(rng);
  const Eigen::Vector3d point = PointBefore(pose, rng);
  const Eigen::Matrix<double, 2, 3> by_correction = Eigen::Matrix<double, 2, 3>::Random();
  const std::unique_ptr<ceres::CostFunction> cost(
      MakeUncalibratedCost({0.1, -0.2}, 0.5, by_correction));
  const std::unique_ptr<ceres::CostFunction> plain(MakeReprojectionCost({0.1, -0.2}, 0.5));
  IntrinsicsBlock intrinsics{};
  RowMajor by_pose(2, kPoseSize), by_point(2, 3), by_block(2, kIntrinsicsSize);
  RowMajor plain_by_pose(2, kPoseSize), plain_by_point(2, 3);
  const double* blocks[] = {pose.data(), point.data(), intrinsics.data()};
  double* jacobians[] = {by_pose.data(), by_point.data(), by_block.data()};
  double* plain_jacobians[] = {plain_by_pose.data(), plain_by_point.data()};
  Eigen::Vector2d residual, plain_residual;
  ASSERT_TRUE(cost->Evaluate(blocks, residual.data(), jacobians));
  ASSERT_TRUE(plain->Evaluate(blocks, plain_residual.data(), plain_jacobians));
  EXPECT_EQ(residual, plain_residual);  // without a correction they are one
  EXPECT_EQ(by_pose, plain_by_pose);
  EXPECT_EQ(by_point, plain_by_point);
  for (int i = 0; i < kIntrinsicsSize; ++i) {
    Eigen::Vector2d moved[2];
    for (const int side : {0, 1}) {
      intrinsics[static_cast<size_t>(i)] = side == 0 ? -kStep : kStep;
      ASSERT_TRUE(cost->Evaluate(blocks, moved[side].data(), nullptr));
    }
    intrinsics[static_cast<size_t>(i)] = 0.0;
    const Eigen::Vector2d numeric = (moved[1] - moved[0]) / (2.0 * kStep);
    EXPECT_LT((numeric - by_block.col(i)).norm(), 1e-6) << "intrinsics " << i;
  }
}

TEST(ReprojectionCost, IsTheProjectionErrorInSigmas) {
  Pose pose = Pose::Zero();
  pose[3] = 1.0;
  const std::unique_ptr<ceres::CostFunction> cost(MakeReprojectionCost({0.1, -0.2}, 0.01));
  EXPECT_LT(Residual(*cost, pose, {0.2, -0.4, 2.0}).norm(), 1e-12);
  EXPECT_LT((Residual(*cost, pose, {0.24, -0.4, 2.0}) - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-12);
}

TEST(ReprojectionCost, RefusesPointsBehindTheCamera) {
  Pose pose = Pose::Zero();
  pose[3] = 1.0;
  const Eigen::Vector3d point(0.0, 0.0, -1.0);
  const double* blocks[] = {pose.data(), point.data()};
  Eigen::Vector2d residual;
  const std::unique_ptr<ceres::CostFunction> cost(MakeReprojectionCost({0.0, 0.0}, 1.0));
  EXPECT_FALSE(cost->Evaluate(blocks, residual.data(), nullptr));
}

TEST(PoseManifold, MinusUndoesPlus) {
  Rng rng(2);
  for (int trial = 0; trial < 20; ++trial) {
    const int fixed_component = trial % 4 - 1;
    const std::unique_ptr<ceres::Manifold> manifold(MakePoseManifold(fixed_component));
    const Pose pose = AnyPose(rng);
    Eigen::VectorXd delta(manifold->TangentSize());
    for (auto& value : delta) value = rng.Uniform(-1, 1);
    if (fixed_component >= 0) delta[3 + fixed_component] = 0.0;
    Pose moved;
    Eigen::VectorXd back(manifold->TangentSize());
    ASSERT_TRUE(manifold->Plus(pose.data(), delta.data(), moved.data()));
    ASSERT_TRUE(manifold->Minus(moved.data(), pose.data(), back.data()));
    EXPECT_LT((back - delta).norm(), 1e-9);
    EXPECT_NEAR(moved.head<4>().norm(), 1.0, 1e-12);
  }
}

TEST(PoseManifold, ANoStepStays) {
  Rng rng(3);
  const std::unique_ptr<ceres::Manifold> manifold(MakePoseManifold(-1));
  const Pose pose = AnyPose(rng);
  EXPECT_LT((Plus(*manifold, pose, 0, 0.0) - pose).norm(), 1e-15);
}

TEST(PoseManifold, KeepsTheFixedComponent) {
  Rng rng(4);
  for (int fixed = 0; fixed < 3; ++fixed) {
    const std::unique_ptr<ceres::Manifold> manifold(MakePoseManifold(fixed));
    const Pose pose = AnyPose(rng);
    const Eigen::VectorXd delta = Eigen::VectorXd::Constant(manifold->TangentSize(), 0.3);
    Pose moved;
    ASSERT_TRUE(manifold->Plus(pose.data(), delta.data(), moved.data()));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(moved[4 + i] - pose[4 + i], i == fixed ? 0.0 : 0.3, 1e-15);
    }
  }
}

}  // namespace
}  // namespace rovio_sfm
