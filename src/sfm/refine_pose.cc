#include "rovio_sfm/sfm/refine_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace rovio_sfm {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kMinDepth = 1e-9;
constexpr double kConverged = 1e-10;
constexpr double kMinEigenvalue = 1e-12;  // of the normalised Hessian; rounding leaves about 1e-16

// The cost at a pose, and its Gauss-Newton system in (rotation, translation), left-multiplied.
struct NormalEquations {
  Matrix6d hessian = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
  double cost = 0.0;
  int num_points = 0;
};

double Loss(double squared, double scale) {
  return scale > 0.0 ? scale * scale * std::log1p(squared / (scale * scale)) : squared;
}

double Weight(double squared, double scale) {
  return scale > 0.0 ? 1.0 / (1.0 + squared / (scale * scale)) : 1.0;
}

NormalEquations Linearize(const std::vector<PoseObservation>& observations,
                          const Rigid3& cam_from_map, double loss_sigmas) {
  NormalEquations system;
  for (const PoseObservation& observation : observations) {
    const Eigen::Vector3d rotated = cam_from_map.rotation * observation.point;
    const Eigen::Vector3d x = rotated + cam_from_map.translation;
    if (!(x.z() > kMinDepth)) {
      system.cost += Loss(1e6, loss_sigmas);
      continue;
    }
    const Eigen::Vector2d residual =
        (x.hnormalized() - observation.x_normalized) / observation.sigma;
    Eigen::Matrix<double, 2, 3> projection;
    projection << 1, 0, -x.x() / x.z(), 0, 1, -x.y() / x.z();
    projection /= x.z() * observation.sigma;
    Eigen::Matrix<double, 2, 6> jacobian;
    jacobian.col(0) = projection * Eigen::Vector3d::UnitX().cross(rotated);
    jacobian.col(1) = projection * Eigen::Vector3d::UnitY().cross(rotated);
    jacobian.col(2) = projection * Eigen::Vector3d::UnitZ().cross(rotated);
    jacobian.rightCols<3>() = projection;
    const double squared = residual.squaredNorm();
    const double weight = Weight(squared, loss_sigmas);
    system.hessian += weight * jacobian.transpose() * jacobian;
    system.gradient += weight * jacobian.transpose() * residual;
    system.cost += Loss(squared, loss_sigmas);
    ++system.num_points;
  }
  return system;
}

Rigid3 Step(const Rigid3& cam_from_map, const Vector6d& delta) {
  const Eigen::Vector3d w = delta.head<3>();
  const double angle = w.norm();
  Rigid3 stepped = cam_from_map;
  if (angle > 0.0) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, w / angle));
    stepped.rotation = (turn * cam_from_map.rotation).normalized();
  }
  stepped.translation += delta.tail<3>();
  return stepped;
}

// False where some motion changes no residual: too few different points, or all on one line.
bool DeterminesPose(const NormalEquations& system) {
  const Vector6d scale = system.hessian.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return false;
  const Matrix6d normalised = scale.asDiagonal() * system.hessian * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(normalised, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] > kMinEigenvalue;
}

}  // namespace

std::optional<Rigid3> RefinePose(const std::vector<PoseObservation>& observations,
                                 const Rigid3& initial_cam_from_map,
                                 const RefinePoseOptions& options) {
  Rigid3 pose = initial_cam_from_map;
  NormalEquations system = Linearize(observations, pose, options.loss_sigmas);
  double damping = 1e-6;
  for (int i = 0; i < options.max_iterations; ++i) {
    if (system.num_points < 3) return std::nullopt;
    Matrix6d damped = system.hessian;
    damped.diagonal() *= 1.0 + damping;
    const Eigen::LDLT<Matrix6d> solver(damped);
    if (solver.info() != Eigen::Success || !solver.isPositive()) return std::nullopt;
    const Vector6d delta = solver.solve(-system.gradient);
    if (!delta.allFinite()) return std::nullopt;
    const Rigid3 stepped = Step(pose, delta);
    const NormalEquations next = Linearize(observations, stepped, options.loss_sigmas);
    if (next.num_points < system.num_points || next.cost > system.cost) {
      damping *= 10.0;
      if (damping > 1e6) break;
      continue;
    }
    pose = stepped;
    system = next;
    damping *= 0.1;
    if (delta.norm() < kConverged) break;
  }
  if (!DeterminesPose(system)) return std::nullopt;
  return pose;
}

}  // namespace rovio_sfm
