#include "rovio_sfm/sfm/planar_motion_cost.h"

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Blocks = std::vector<Eigen::VectorXd>;

constexpr double kStep = 1e-6;

Eigen::VectorXd AnyVector(int size, Rng& rng) {
  Eigen::VectorXd vector(size);
  for (double& value : vector) value = rng.Uniform(-1, 1);
  return vector;
}

// A pose, a normal and a third block of that size.
Blocks AnyBlocks(int size, Rng& rng) {
  Eigen::VectorXd pose(kPoseSize);
  pose.head<4>() = AnyVector(4, rng).normalized();
  pose.tail<3>() = AnyVector(3, rng);
  return {pose, AnyVector(3, rng).normalized(), AnyVector(size, rng)};
}

Eigen::VectorXd Residuals(const ceres::CostFunction& cost, const Blocks& blocks) {
  const double* data[] = {blocks[0].data(), blocks[1].data(), blocks[2].data()};
  Eigen::VectorXd residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(data, residuals.data(), nullptr));
  return residuals;
}

Blocks Moved(const Blocks& blocks, size_t block, int component, double step) {
  Blocks moved = blocks;
  if (block > 0) {
    moved[block][component] += step;
    return moved;
  }
  const std::unique_ptr<ceres::Manifold> manifold(MakePoseManifold(-1));
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(6);
  delta[component] = step;
  EXPECT_TRUE(manifold->Plus(blocks[0].data(), delta.data(), moved[0].data()));
  return moved;
}

void CheckJacobians(const ceres::CostFunction& cost, const Blocks& blocks) {
  std::vector<RowMajor> by;
  for (const auto& block : blocks) by.emplace_back(cost.num_residuals(), block.size());
  const double* data[] = {blocks[0].data(), blocks[1].data(), blocks[2].data()};
  double* jacobians[] = {by[0].data(), by[1].data(), by[2].data()};
  Eigen::VectorXd residuals(cost.num_residuals());
  ASSERT_TRUE(cost.Evaluate(data, residuals.data(), jacobians));
  EXPECT_EQ(residuals, Residuals(cost, blocks));
  for (size_t k = 0; k < blocks.size(); ++k) {
    const int size = k == 0 ? 6 : static_cast<int>(blocks[k].size());
    for (int i = 0; i < size; ++i) {
      const Eigen::VectorXd numeric = (Residuals(cost, Moved(blocks, k, i, kStep)) -
                                       Residuals(cost, Moved(blocks, k, i, -kStep))) /
                                      (2.0 * kStep);
      EXPECT_LT((numeric - by[k].col(i)).norm(), 1e-6) << "block " << k << ", component " << i;
    }
  }
  EXPECT_EQ(by[0].col(6).norm(), 0.0);  // no tangent
}

TEST(TiltCost, JacobiansAreThoseOfFiniteDifferences) {
  Rng rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Quaterniond base_from_cam(Eigen::Vector4d(AnyVector(4, rng).normalized()));
    const std::unique_ptr<ceres::CostFunction> cost(MakeTiltCost(base_from_cam, 0.5));
    CheckJacobians(*cost, AnyBlocks(2, rng));
  }
}

TEST(HeightCost, JacobiansAreThoseOfFiniteDifferences) {
  Rng rng(2);
  for (int trial = 0; trial < 20; ++trial) {
    const std::unique_ptr<ceres::CostFunction> cost(MakeHeightCost(AnyVector(3, rng), 0.5));
    CheckJacobians(*cost, AnyBlocks(1, rng));
  }
}

Eigen::VectorXd IdentityPose() { return Eigen::VectorXd::Unit(kPoseSize, 3); }

TEST(TiltCost, IsTheNormalsTiltInTheBaseInSigmas) {
  // The base's x is the camera's z, its z the camera's -y.
  const Eigen::Quaterniond base_from_cam(0.5, -0.5, 0.5, -0.5);
  const std::unique_ptr<ceres::CostFunction> cost(MakeTiltCost(base_from_cam, 0.01));
  const Eigen::Vector2d upright(0.0, 0.0), tilted(0.02, 0.0);
  EXPECT_LT(Residuals(*cost, {IdentityPose(), Eigen::Vector3d(0, -1, 0), upright}).norm(), 1e-12);
  const Eigen::Vector3d forward(0.0, -std::cos(0.02), std::sin(0.02));
  const Eigen::VectorXd off = Residuals(*cost, {IdentityPose(), forward, upright});
  EXPECT_LT((off - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-3) << off.transpose();
  EXPECT_LT(Residuals(*cost, {IdentityPose(), forward, tilted}).norm(), 1e-3);
}

TEST(HeightCost, IsTheDistanceFromThePlaneInSigmas) {
  Eigen::VectorXd pose = IdentityPose();
  pose[5] = -0.3;  // the camera stands at y = 0.3
  const std::unique_ptr<ceres::CostFunction> cost(MakeHeightCost({0.1, 0.2, 0.7}, 0.01));
  const Eigen::Vector3d up(0, -1, 0);
  EXPECT_NEAR(Residuals(*cost, {pose, up, Eigen::VectorXd::Constant(1, -0.5)})[0], 0.0, 1e-12);
  EXPECT_NEAR(Residuals(*cost, {pose, up, Eigen::VectorXd::Constant(1, -0.52)})[0], 2.0, 1e-9);
}

}  // namespace
}  // namespace rovio_sfm
