#include "rovio_sfm/sfm/reprojection_cost.h"

#include <ceres/cost_function.h>
#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

#include <Eigen/Geometry>

namespace rovio_sfm {
namespace {

using RowMajor2x7 = Eigen::Matrix<double, 2, kPoseSize, Eigen::RowMajor>;
using RowMajor2x3 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;

constexpr double kMinDepth = 1e-9;
constexpr int kTangentSize = 6;  // always: Ceres is fast where all cameras have the same

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

class ReprojectionCost final : public ceres::SizedCostFunction<2, kPoseSize, 3> {
 public:
  ReprojectionCost(const Eigen::Vector2d& x_normalized, double sigma)
      : x_normalized_(x_normalized), weight_(1.0 / sigma) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Quaterniond> rotation(parameters[0]);
    const Eigen::Map<const Eigen::Vector3d> translation(parameters[0] + 4), point(parameters[1]);
    const Eigen::Vector3d rotated = rotation * point;
    const Eigen::Vector3d x_in_cam = rotated + translation;
    if (!(x_in_cam.z() > kMinDepth)) return false;  // Ceres shortens the step
    Eigen::Map<Eigen::Vector2d> residual(residuals);
    residual = weight_ * (x_in_cam.hnormalized() - x_normalized_);
    if (jacobians == nullptr) return true;

    const double inverse_z = 1.0 / x_in_cam.z();
    Eigen::Matrix<double, 2, 3> projection;
    projection << 1, 0, -x_in_cam.x() * inverse_z, 0, 1, -x_in_cam.y() * inverse_z;
    projection *= weight_ * inverse_z;
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMajor2x7> by_pose(jacobians[0]);
      by_pose.leftCols<3>() = -projection * CrossMatrix(rotated);
      by_pose.middleCols<3>(3) = projection;
      by_pose.col(6).setZero();
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RowMajor2x3> by_point(jacobians[1]);
      by_point = projection * rotation.toRotationMatrix();
    }
    return true;
  }

 private:
  Eigen::Vector2d x_normalized_;
  double weight_;
};

class PoseManifold final : public ceres::Manifold {
 public:
  explicit PoseManifold(int fixed_component) : fixed_component_(fixed_component) {}

  int AmbientSize() const override { return kPoseSize; }
  int TangentSize() const override { return kTangentSize; }

  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    const Eigen::Vector3d w(delta[0], delta[1], delta[2]);
    const double angle = w.norm();
    const Eigen::Quaterniond step(angle > 0.0 ? Eigen::AngleAxisd(angle, w / angle)
                                              : Eigen::AngleAxisd::Identity());
    Eigen::Map<Eigen::Quaterniond> rotation(x_plus_delta);
    rotation = (step * Eigen::Map<const Eigen::Quaterniond>(x)).normalized();
    for (int i = 0; i < 3; ++i) {
      x_plus_delta[4 + i] = x[4 + i] + (i == fixed_component_ ? 0.0 : delta[3 + i]);
    }
    return true;
  }

  // Selects the columns that MakeReprojectionCost filled, see there; that of the fixed component
  // is zero.
  bool PlusJacobian(const double*, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, kPoseSize, kTangentSize, Eigen::RowMajor>> select(jacobian);
    select.setZero();
    select.topRows<kTangentSize>().setIdentity();
    if (fixed_component_ >= 0) select(3 + fixed_component_, 3 + fixed_component_) = 0.0;
    return true;
  }

  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    const Eigen::Map<const Eigen::Quaterniond> after(y), before(x);
    const Eigen::AngleAxisd step(after * before.conjugate());
    Eigen::Map<Eigen::Vector3d>{y_minus_x} = step.angle() * step.axis();
    for (int i = 0; i < 3; ++i) {
      y_minus_x[3 + i] = i == fixed_component_ ? 0.0 : y[4 + i] - x[4 + i];
    }
    return true;
  }

  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Matrix<double, kPoseSize, kTangentSize, Eigen::RowMajor> plus;
    PlusJacobian(x, plus.data());
    Eigen::Map<Eigen::Matrix<double, kTangentSize, kPoseSize, Eigen::RowMajor>>{jacobian} =
        plus.transpose();
    return true;
  }

 private:
  int fixed_component_;
};

}  // namespace

ceres::CostFunction* MakeReprojectionCost(const Eigen::Vector2d& x_normalized, double sigma) {
  return new ReprojectionCost(x_normalized, sigma);
}

ceres::Manifold* MakePoseManifold(int fixed_component) { return new PoseManifold(fixed_component); }

}  // namespace rovio_sfm
