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

// (projection - seen) * weight, and its Jacobians by pose and point.
bool Project(double const* const* parameters, const Eigen::Vector2d& seen, double weight,
             double* residuals, double** jacobians) {
  const Eigen::Map<const Eigen::Quaterniond> rotation(parameters[0]);
  const Eigen::Map<const Eigen::Vector3d> translation(parameters[0] + 4), point(parameters[1]);
  const Eigen::Vector3d rotated = rotation * point;
  const Eigen::Vector3d x_in_cam = rotated + translation;
  if (!(x_in_cam.z() > kMinDepth)) return false;  // Ceres shortens the step
  Eigen::Map<Eigen::Vector2d> residual(residuals);
  residual = weight * (x_in_cam.hnormalized() - seen);
  if (jacobians == nullptr) return true;

  const double inverse_z = 1.0 / x_in_cam.z();
  Eigen::Matrix<double, 2, 3> projection;
  projection << 1, 0, -x_in_cam.x() * inverse_z, 0, 1, -x_in_cam.y() * inverse_z;
  projection *= weight * inverse_z;
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

class ReprojectionCost final : public ceres::SizedCostFunction<2, kPoseSize, 3> {
 public:
  ReprojectionCost(const Eigen::Vector2d& x_normalized, double sigma)
      : x_normalized_(x_normalized), weight_(1.0 / sigma) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    return Project(parameters, x_normalized_, weight_, residuals, jacobians);
  }

 private:
  Eigen::Vector2d x_normalized_;
  double weight_;
};

class UncalibratedCost final : public ceres::SizedCostFunction<2, kPoseSize, 3, kIntrinsicsSize> {
 public:
  UncalibratedCost(const Eigen::Vector2d& x_normalized, double sigma,
                   const Eigen::Matrix<double, 2, 3>& by_correction)
      : x_normalized_(x_normalized), weight_(1.0 / sigma), by_correction_(by_correction) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> correction(parameters[2]);
    const double zoom = 1.0 + correction[0];
    const Eigen::Vector2d shift = by_correction_ * correction;
    const Eigen::Vector2d seen = x_normalized_ + shift / zoom;
    if (!Project(parameters, seen, weight_ * zoom, residuals, jacobians)) return false;
    if (jacobians == nullptr || jacobians[2] == nullptr) return true;
    const Eigen::Map<const Eigen::Vector2d> residual(residuals);
    Eigen::Map<Eigen::Matrix<double, 2, kIntrinsicsSize, Eigen::RowMajor>> by_block(jacobians[2]);
    by_block << -weight_ * by_correction_, Eigen::Matrix<double, 2, 3>::Zero();
    by_block.col(0) += (residual + weight_ * shift) / zoom;
    return true;
  }

 private:
  Eigen::Vector2d x_normalized_;
  double weight_;
  Eigen::Matrix<double, 2, 3> by_correction_;
};

class IntrinsicsCost final : public ceres::SizedCostFunction<kIntrinsicsSize, kIntrinsicsSize> {
 public:
  IntrinsicsCost(const Eigen::Vector3d& expected, const Eigen::Vector3d& sigma) {
    expected_ << expected, Eigen::Vector3d::Zero();
    weight_ << sigma.cwiseInverse(), Eigen::Vector3d::Ones();
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Vector> block(parameters[0]);
    Eigen::Map<Vector>{residuals} = weight_.cwiseProduct(block - expected_);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    using Matrix = Eigen::Matrix<double, kIntrinsicsSize, kIntrinsicsSize, Eigen::RowMajor>;
    Eigen::Map<Matrix>{jacobians[0]} = weight_.asDiagonal();
    return true;
  }

 private:
  using Vector = Eigen::Matrix<double, kIntrinsicsSize, 1>;
  Vector expected_, weight_;
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

ceres::CostFunction* MakeUncalibratedCost(const Eigen::Vector2d& x_normalized, double sigma,
                                          const Eigen::Matrix<double, 2, 3>& by_correction) {
  return new UncalibratedCost(x_normalized, sigma, by_correction);
}

ceres::CostFunction* MakeIntrinsicsCost(const Eigen::Vector3d& expected,
                                        const Eigen::Vector3d& sigma) {
  return new IntrinsicsCost(expected, sigma);
}

ceres::Manifold* MakePoseManifold(int fixed_component) { return new PoseManifold(fixed_component); }

}  // namespace rovio_sfm
