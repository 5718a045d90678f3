#include "rovio_sfm/geometry/relative_pose.h"

#include <Eigen/Dense>
#include <cmath>

#include "rovio_sfm/geometry/essential.h"

namespace rovio_sfm {
namespace {

using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

// Normal equations of the Sampson residuals at one pose.
struct PoseSystem {
  Matrix5d normal = Matrix5d::Zero();
  Vector5d gradient = Vector5d::Zero();
  double cost = 0.0;
};

// Cauchy's loss of a squared residual, or the squared residual itself where the scale is 0.
double Loss(double squared_residual, double scale) {
  if (scale <= 0.0) return squared_residual;
  return scale * scale * std::log1p(squared_residual / (scale * scale));
}

// The derivative of Loss: the weight of a residual in the normal equations.
double Weight(double squared_residual, double scale) {
  return scale <= 0.0 ? 1.0 : 1.0 / (1.0 + squared_residual / (scale * scale));
}

PoseSystem Linearize(const std::vector<Eigen::Vector2d>& points_a,
                     const std::vector<Eigen::Vector2d>& points_b, const Rigid3& b_from_a,
                     double loss_scale) {
  const SampsonEvaluator evaluator(b_from_a);
  PoseSystem system;
  for (size_t i = 0; i < points_a.size(); ++i) {
    const SampsonResidual residual = evaluator.Evaluate(points_a[i], points_b[i]);
    const double squared = residual.value * residual.value;
    const double weight = Weight(squared, loss_scale);
    system.normal += weight * residual.jacobian.transpose() * residual.jacobian;
    system.gradient += weight * residual.value * residual.jacobian.transpose();
    system.cost += Loss(squared, loss_scale);
  }
  return system;
}

double SampsonCost(const std::vector<Eigen::Vector2d>& points_a,
                   const std::vector<Eigen::Vector2d>& points_b, const Rigid3& b_from_a,
                   double loss_scale) {
  const Eigen::Matrix3d essential = EssentialFromPose(b_from_a);
  double cost = 0.0;
  for (size_t i = 0; i < points_a.size(); ++i) {
    cost += Loss(SquaredSampsonError(essential, points_a[i], points_b[i]), loss_scale);
  }
  return cost;
}

}  // namespace

SampsonEvaluator::SampsonEvaluator(const Rigid3& b_from_a) {
  const Eigen::Matrix3d rotation = b_from_a.rotation.toRotationMatrix();
  const auto cross_times_rotation = [&rotation](const Eigen::Vector3d& v) {
    return Eigen::Matrix3d(-rotation.colwise().cross(v));
  };
  essential_ = cross_times_rotation(b_from_a.translation);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix3d turned = -rotation.colwise().cross(Eigen::Vector3d::Unit(k));
    derivatives_[k] = -turned.colwise().cross(b_from_a.translation);
  }
  const Eigen::Matrix<double, 3, 2> tangent = TranslationTangent(b_from_a.translation);
  for (int k = 0; k < 2; ++k) derivatives_[3 + k] = cross_times_rotation(tangent.col(k));
}

SampsonResidual SampsonEvaluator::Evaluate(const Eigen::Vector2d& x_a,
                                           const Eigen::Vector2d& x_b) const {
  const Eigen::Vector3d ray_a = x_a.homogeneous(), ray_b = x_b.homogeneous();
  const Eigen::Vector3d line_b = essential_ * ray_a;
  const Eigen::Vector2d line_a = essential_.leftCols<2>().transpose() * ray_b;
  const double error = ray_b.dot(line_b);
  const double squared_norm = line_b.head<2>().squaredNorm() + line_a.squaredNorm();
  SampsonResidual residual;
  if (!(squared_norm > 0.0)) return residual;
  const double inverse_norm = 1.0 / std::sqrt(squared_norm);
  residual.value = error * inverse_norm;
  for (int k = 0; k < 5; ++k) {
    const Eigen::Vector3d line_b_change = derivatives_[k] * ray_a;
    const Eigen::Vector2d line_a_change = derivatives_[k].leftCols<2>().transpose() * ray_b;
    const double half_norm_change =
        line_b.head<2>().dot(line_b_change.head<2>()) + line_a.dot(line_a_change);
    residual.jacobian(k) =
        inverse_norm * (ray_b.dot(line_b_change) - error * half_norm_change / squared_norm);
  }
  return residual;
}

Eigen::Matrix<double, 3, 2> TranslationTangent(const Eigen::Vector3d& translation) {
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = translation.unitOrthogonal();
  tangent.col(1) = translation.normalized().cross(tangent.col(0));
  return tangent;
}

Rigid3 ApplyPoseStep(const Rigid3& b_from_a, const Eigen::Matrix<double, 5, 1>& step) {
  const Eigen::Vector3d turn = step.head<3>();
  const double angle_rad = turn.norm();
  Rigid3 moved = b_from_a;
  if (angle_rad > 0.0) {
    const Eigen::Quaterniond change(Eigen::AngleAxisd(angle_rad, turn / angle_rad));
    moved.rotation = (change * b_from_a.rotation).normalized();
  }
  moved.translation =
      (b_from_a.translation + TranslationTangent(b_from_a.translation) * step.tail<2>())
          .normalized();
  return moved;
}

std::optional<Rigid3> RefineRelativePose(const std::vector<Eigen::Vector2d>& points_a,
                                         const std::vector<Eigen::Vector2d>& points_b,
                                         const Rigid3& b_from_a, int max_steps, double loss_scale) {
  constexpr double kConverged = 1e-6;  // relative change of the cost
  if (points_a.size() < 5 || points_a.size() != points_b.size()) return std::nullopt;
  if (!(b_from_a.translation.norm() > 0.0)) return std::nullopt;
  Rigid3 pose{b_from_a.rotation, b_from_a.translation.normalized()};
  PoseSystem system = Linearize(points_a, points_b, pose, loss_scale);
  double damping = 1e-4;
  for (int step = 0; step < max_steps; ++step) {
    Matrix5d damped = system.normal;
    damped.diagonal() *= 1.0 + damping;
    const Rigid3 candidate = ApplyPoseStep(pose, -damped.ldlt().solve(system.gradient));
    const double cost = SampsonCost(points_a, points_b, candidate, loss_scale);
    if (!(cost < system.cost)) {
      damping *= 10.0;
      continue;
    }
    const bool converged = cost > (1.0 - kConverged) * system.cost;
    pose = candidate;
    if (converged) break;
    damping *= 0.1;
    system = Linearize(points_a, points_b, pose, loss_scale);
  }
  return pose;
}

std::optional<Eigen::Quaterniond> EstimateRotation(const std::vector<Eigen::Vector2d>& points_a,
                                                   const std::vector<Eigen::Vector2d>& points_b) {
  if (points_a.size() < 2 || points_a.size() != points_b.size()) return std::nullopt;
  Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < points_a.size(); ++i) {
    correlation +=
        points_b[i].homogeneous().normalized() * points_a[i].homogeneous().normalized().transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  return Eigen::Quaterniond(rotation);
}

}  // namespace rovio_sfm
