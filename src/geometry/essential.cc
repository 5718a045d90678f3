#include "rovio_sfm/geometry/essential.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "rovio_sfm/geometry/normalize_points.h"

namespace rovio_sfm {
namespace {

using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;
using RowMajor3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr double kMinEigenvalueRatio = 1e-13;  // of the equations; below it E is undetermined
constexpr int kMaxAlgebraicSteps = 10;

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

Eigen::Matrix3d MatrixFromStack(const Vector9d& stack) {
  return Eigen::Map<const RowMajor3d>(stack.data());
}

// The epipolar equations of all matches in normalised form, reduced to 9 rows: |rows * E| is the
// algebraic error |A E| of the stacked, normalised E (Eq. A.4.29).
struct EpipolarEquations {
  Eigen::Matrix3d transform_a, transform_b;
  Matrix9d rows;
  Vector9d solution;  // of the least squares without the rank constraint

  Eigen::Matrix3d Denormalize(const Eigen::Matrix3d& normalized) const {
    return transform_b.transpose() * normalized * transform_a;
  }
};

std::optional<EpipolarEquations> BuildEquations(const std::vector<Eigen::Vector2d>& points_a,
                                                const std::vector<Eigen::Vector2d>& points_b) {
  const auto matches = NormalizeMatches(points_a, points_b, 8);
  if (!matches) return std::nullopt;
  Matrix9d normal = Matrix9d::Zero();
  for (size_t i = 0; i < matches->x_a.size(); ++i) {
    const Eigen::Vector3d& x_a = matches->x_a[i];
    const Eigen::Vector3d& x_b = matches->x_b[i];
    Vector9d row;
    row << x_b.x() * x_a, x_b.y() * x_a, x_b.z() * x_a;
    normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix9d> solver(normal);
  const Vector9d eigenvalues = solver.eigenvalues().cwiseMax(0.0);
  if (!(eigenvalues(1) > kMinEigenvalueRatio * eigenvalues(8))) return std::nullopt;
  return EpipolarEquations{matches->transform_a, matches->transform_b,
                           eigenvalues.cwiseSqrt().asDiagonal() * solver.eigenvectors().transpose(),
                           solver.eigenvectors().col(0)};
}

Eigen::Matrix<double, 3, 2> TangentBasis(const Eigen::Vector3d& unit) {
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = unit.unitOrthogonal();
  basis.col(1) = unit.cross(basis.col(0));
  return basis;
}

// The stacked E, |E| = 1, E e = 0, of least algebraic error for a given epipole; its sign is that
// of the reference. The rows of such an E are spanned by the two directions normal to e.
Vector9d MinimizeForEpipole(const Matrix9d& rows, const Eigen::Vector3d& epipole,
                            const Vector9d& reference) {
  const Eigen::Matrix<double, 3, 2> normals = TangentBasis(epipole);
  Eigen::Matrix<double, 9, 6> basis = Eigen::Matrix<double, 9, 6>::Zero();
  for (int i = 0; i < 3; ++i) basis.block<3, 2>(3 * i, 2 * i) = normals;
  const Eigen::Matrix<double, 9, 6> reduced = rows * basis;
  const Eigen::Matrix<double, 6, 6> normal = reduced.transpose() * reduced;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(normal);
  const Vector9d stack = basis * solver.eigenvectors().col(0);
  return stack.dot(reference) < 0.0 ? Vector9d(-stack) : stack;
}

// One damped step over the two degrees of freedom of the unit epipole, by numeric derivatives.
Eigen::Vector3d StepEpipole(const Matrix9d& rows, const Eigen::Vector3d& epipole,
                            const Vector9d& stack, double damping) {
  constexpr double kDelta = 1e-6;
  const Eigen::Matrix<double, 3, 2> tangent = TangentBasis(epipole);
  Eigen::Matrix<double, 9, 2> jacobian;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d moved = (epipole + kDelta * tangent.col(k)).normalized();
    jacobian.col(k) = rows * (MinimizeForEpipole(rows, moved, stack) - stack) / kDelta;
  }
  Eigen::Matrix2d normal = jacobian.transpose() * jacobian;
  normal.diagonal() *= 1.0 + damping;
  const Eigen::Vector2d step = -normal.ldlt().solve(jacobian.transpose() * (rows * stack));
  return (epipole + tangent * step).normalized();
}

// Levenberg-Marquardt over the epipole; returns the stacked, normalised E.
Vector9d MinimizeOverEpipole(const EpipolarEquations& equations) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(MatrixFromStack(equations.solution),
                                              Eigen::ComputeFullV);
  Eigen::Vector3d epipole = svd.matrixV().col(2);
  Vector9d stack = MinimizeForEpipole(equations.rows, epipole, equations.solution);
  double cost = (equations.rows * stack).squaredNorm();
  double damping = 1e-3;
  for (int step = 0; step < kMaxAlgebraicSteps; ++step) {
    const Eigen::Vector3d moved = StepEpipole(equations.rows, epipole, stack, damping);
    const Vector9d candidate = MinimizeForEpipole(equations.rows, moved, stack);
    const double candidate_cost = (equations.rows * candidate).squaredNorm();
    if (candidate_cost < cost) {
      const bool converged = candidate_cost > (1.0 - 1e-9) * cost;
      epipole = moved;
      stack = candidate;
      cost = candidate_cost;
      damping *= 0.1;
      if (converged) break;
    } else {
      damping *= 10.0;
    }
  }
  return stack;
}

}  // namespace

Eigen::Matrix3d EssentialFromPose(const Rigid3& b_from_a) {
  return CrossMatrix(b_from_a.translation.normalized()) * b_from_a.rotation.toRotationMatrix();
}

Eigen::Matrix3d ProjectOnEssentialSpace(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU().leftCols<2>() * svd.matrixV().leftCols<2>().transpose();
}

std::optional<Eigen::Matrix3d> EstimateEightPoint(const std::vector<Eigen::Vector2d>& points_a,
                                                  const std::vector<Eigen::Vector2d>& points_b) {
  const std::optional<EpipolarEquations> equations = BuildEquations(points_a, points_b);
  if (!equations) return std::nullopt;
  return ProjectOnEssentialSpace(equations->Denormalize(MatrixFromStack(equations->solution)));
}

std::optional<Eigen::Matrix3d> EstimateAlgebraic(const std::vector<Eigen::Vector2d>& points_a,
                                                 const std::vector<Eigen::Vector2d>& points_b) {
  const std::optional<EpipolarEquations> equations = BuildEquations(points_a, points_b);
  if (!equations) return std::nullopt;
  return ProjectOnEssentialSpace(
      equations->Denormalize(MatrixFromStack(MinimizeOverEpipole(*equations))));
}

std::array<Rigid3, 4> DecomposeEssential(const Eigen::Matrix3d& essential) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(essential, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU(), v = svd.matrixV();
  if (u.determinant() < 0.0) u = -u;
  if (v.determinant() < 0.0) v = -v;
  Eigen::Matrix3d w;
  w << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  const Eigen::Quaterniond rotation_1(Eigen::Matrix3d(u * w * v.transpose()));
  const Eigen::Quaterniond rotation_2(Eigen::Matrix3d(u * w.transpose() * v.transpose()));
  const Eigen::Vector3d translation = u.col(2);
  return {Rigid3{rotation_1, translation}, Rigid3{rotation_1, -translation},
          Rigid3{rotation_2, translation}, Rigid3{rotation_2, -translation}};
}

bool IsInFront(const Rigid3& b_from_a, const Eigen::Vector2d& x_a, const Eigen::Vector2d& x_b) {
  // depth_b ray_b = depth_a ray_a + t, ray_a turned into b; each depth by crossing out the other.
  const Eigen::Vector3d ray_a = b_from_a.rotation * x_a.homogeneous();
  const Eigen::Vector3d ray_b = x_b.homogeneous();
  const Eigen::Vector3d normal = ray_a.cross(ray_b);
  const double depth_a_scaled = -normal.dot(b_from_a.translation.cross(ray_b));
  const double depth_b_scaled = normal.dot(ray_a.cross(b_from_a.translation));
  return depth_a_scaled > 0.0 && depth_b_scaled > 0.0;
}

std::optional<Rigid3> PoseFromEssential(const Eigen::Matrix3d& essential,
                                        const std::vector<Eigen::Vector2d>& points_a,
                                        const std::vector<Eigen::Vector2d>& points_b) {
  if (points_a.size() != points_b.size()) return std::nullopt;
  std::optional<Rigid3> best;
  size_t best_count = points_a.size() / 2;
  for (const Rigid3& b_from_a : DecomposeEssential(essential)) {
    size_t count = 0;
    for (size_t i = 0; i < points_a.size(); ++i) {
      count += IsInFront(b_from_a, points_a[i], points_b[i]) ? 1 : 0;
    }
    if (count > best_count) {
      best_count = count;
      best = b_from_a;
    }
  }
  return best;
}

}  // namespace rovio_sfm
