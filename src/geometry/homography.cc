#include "rovio_sfm/geometry/homography.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "rovio_sfm/geometry/normalize_points.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

using Vector8d = Eigen::Matrix<double, 8, 1>;
using Matrix8d = Eigen::Matrix<double, 8, 8>;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;
using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kMinEigenvalueRatio = 1e-13;

std::optional<Eigen::Matrix3d> WithUnitDeterminant(const Eigen::Matrix3d& matrix) {
  const double determinant = matrix.determinant();
  if (!(std::abs(determinant) > 1e-9 * std::pow(matrix.norm(), 3))) return std::nullopt;
  return Eigen::Matrix3d(matrix / std::cbrt(determinant));
}

// The normal equations of the transfer error over the first eight entries, the ninth being fixed.
struct TransferSystem {
  Matrix8d normal = Matrix8d::Zero();
  Vector8d gradient = Vector8d::Zero();
  double cost = 0.0;
};

TransferSystem Linearize(const std::vector<Eigen::Vector2d>& points_a,
                         const std::vector<Eigen::Vector2d>& points_b,
                         const Eigen::Matrix3d& b_from_a) {
  TransferSystem system;
  for (size_t i = 0; i < points_a.size(); ++i) {
    const Eigen::Vector3d ray_a = points_a[i].homogeneous();
    const Eigen::Vector3d ray_b = b_from_a * ray_a;
    const Eigen::Vector2d x = ray_b.hnormalized();
    const Eigen::Vector2d residual = x - points_b[i];
    Eigen::Matrix<double, 2, 8> jacobian = Eigen::Matrix<double, 2, 8>::Zero();
    jacobian.block<1, 3>(0, 0) = ray_a.transpose() / ray_b.z();
    jacobian.block<1, 3>(1, 3) = ray_a.transpose() / ray_b.z();
    jacobian.rightCols<2>() = -x * ray_a.head<2>().transpose() / ray_b.z();
    system.normal += jacobian.transpose() * jacobian;
    system.gradient += jacobian.transpose() * residual;
    system.cost += residual.squaredNorm();
  }
  return system;
}

}  // namespace

std::optional<Eigen::Matrix3d> EstimateHomography(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b) {
  const auto matches = NormalizeMatches(points_a, points_b, 4);
  if (!matches) return std::nullopt;
  Matrix9d normal = Matrix9d::Zero();
  for (size_t i = 0; i < matches->x_a.size(); ++i) {
    const Eigen::Vector3d& x_a = matches->x_a[i];
    const Eigen::Vector3d& x_b = matches->x_b[i];
    for (int k = 0; k < 2; ++k) {
      Vector9d row = Vector9d::Zero();
      row.segment<3>(3 * k) = x_a;
      row.tail<3>() = -x_b(k) * x_a;
      normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Matrix9d> solver(normal);
  const Vector9d& eigenvalues = solver.eigenvalues();
  if (!(eigenvalues(1) > kMinEigenvalueRatio * eigenvalues(8))) return std::nullopt;
  const Vector9d stack = solver.eigenvectors().col(0);
  const Eigen::Matrix3d homography = Eigen::Map<const RowMajor3d>(stack.data());
  return WithUnitDeterminant(matches->transform_b.inverse() * homography * matches->transform_a);
}

std::optional<Eigen::Matrix3d> SolveFourPoint(const std::vector<Eigen::Vector2d>& points_a,
                                              const std::vector<Eigen::Vector2d>& points_b) {
  ROVIO_CHECK(points_a.size() == 4 && points_b.size() == 4);
  Matrix8d equations = Matrix8d::Zero();
  Vector8d right_side;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d x_a = points_a[static_cast<size_t>(i)].homogeneous();
    const Eigen::Vector2d& x_b = points_b[static_cast<size_t>(i)];
    for (int k = 0; k < 2; ++k) {
      equations.block<1, 3>(2 * i + k, 3 * k) = x_a.transpose();
      equations.block<1, 2>(2 * i + k, 6) = -x_b(k) * x_a.head<2>().transpose();
      right_side(2 * i + k) = x_b(k);
    }
  }
  Vector9d stack;
  stack << Eigen::PartialPivLU<Matrix8d>(equations).solve(right_side), 1.0;
  if (!stack.allFinite()) return std::nullopt;
  return WithUnitDeterminant(Eigen::Map<const RowMajor3d>(stack.data()));
}

std::optional<Eigen::Matrix3d> RefineHomography(const std::vector<Eigen::Vector2d>& points_a,
                                                const std::vector<Eigen::Vector2d>& points_b,
                                                const Eigen::Matrix3d& b_from_a, int max_steps) {
  if (points_a.size() < 4 || points_a.size() != points_b.size()) return std::nullopt;
  RowMajor3d homography = b_from_a;
  TransferSystem system = Linearize(points_a, points_b, homography);
  double damping = 1e-6;
  for (int step = 0; step < max_steps; ++step) {
    Matrix8d damped = system.normal;
    damped.diagonal() *= 1.0 + damping;
    RowMajor3d candidate = homography;
    Eigen::Map<Vector8d>(candidate.data()) -= damped.ldlt().solve(system.gradient);
    const TransferSystem next = Linearize(points_a, points_b, candidate);
    if (!(next.cost < system.cost)) {
      damping *= 10.0;
      continue;
    }
    const bool converged = next.cost > (1.0 - 1e-6) * system.cost;
    homography = candidate;
    system = next;
    damping *= 0.1;
    if (converged) break;
  }
  return WithUnitDeterminant(homography);
}

double SquaredTransferError(const Eigen::Matrix3d& b_from_a, const Eigen::Vector2d& x_a,
                            const Eigen::Vector2d& x_b) {
  const Eigen::Vector3d ray_b = b_from_a * x_a.homogeneous();
  if (!(ray_b.z() > 0.0)) return std::numeric_limits<double>::infinity();
  return 0.5 * (ray_b.hnormalized() - x_b).squaredNorm();
}

std::optional<Eigen::Quaterniond> RotationFromHomography(const Eigen::Matrix3d& b_from_a) {
  const auto unit = WithUnitDeterminant(b_from_a);
  if (!unit) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(*unit, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Eigen::Quaterniond(Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
}

}  // namespace rovio_sfm
