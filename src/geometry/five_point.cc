#include "rovio_sfm/geometry/five_point.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "rovio_sfm/geometry/polynomial.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

// Polynomials in x, y, z as coefficient vectors. Degree 1: x y z 1. Degree 2: in the order of
// kQuadratic. Degree 3: in Nistér's order, kCubic, with the monomials to eliminate first.
using Linear = Eigen::Vector4d;
using Quadratic = Eigen::Matrix<double, 10, 1>;
using Cubic = Eigen::Matrix<double, 20, 1>;
using Exponents = std::array<int, 3>;

constexpr std::array<Exponents, 4> kLinear = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
constexpr std::array<Exponents, 10> kQuadratic = {{{2, 0, 0},
                                                   {0, 2, 0},
                                                   {0, 0, 2},
                                                   {1, 1, 0},
                                                   {1, 0, 1},
                                                   {0, 1, 1},
                                                   {1, 0, 0},
                                                   {0, 1, 0},
                                                   {0, 0, 1},
                                                   {0, 0, 0}}};
constexpr std::array<Exponents, 20> kCubic = {
    {{3, 0, 0}, {0, 3, 0}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}, {2, 0, 0}, {0, 2, 1},
     {0, 2, 0}, {1, 1, 1}, {1, 1, 0}, {1, 0, 2}, {1, 0, 1}, {1, 0, 0}, {0, 1, 2},
     {0, 1, 1}, {0, 1, 0}, {0, 0, 3}, {0, 0, 2}, {0, 0, 1}, {0, 0, 0}}};

// Where the product of two monomials lies in the list of the product's degree.
template <size_t kA, size_t kB, size_t kProduct>
constexpr std::array<std::array<int, kB>, kA> MakeProductTable(
    const std::array<Exponents, kA>& a, const std::array<Exponents, kB>& b,
    const std::array<Exponents, kProduct>& product) {
  std::array<std::array<int, kB>, kA> table{};
  for (size_t i = 0; i < kA; ++i) {
    for (size_t j = 0; j < kB; ++j) {
      for (size_t k = 0; k < kProduct; ++k) {
        if (a[i][0] + b[j][0] == product[k][0] && a[i][1] + b[j][1] == product[k][1] &&
            a[i][2] + b[j][2] == product[k][2]) {
          table[i][j] = static_cast<int>(k);
        }
      }
    }
  }
  return table;
}

constexpr auto kLinearTimesLinear = MakeProductTable(kLinear, kLinear, kQuadratic);
constexpr auto kQuadraticTimesLinear = MakeProductTable(kQuadratic, kLinear, kCubic);

void AddProduct(const Linear& a, const Linear& b, double factor, Quadratic* sum) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      (*sum)(kLinearTimesLinear[static_cast<size_t>(i)][static_cast<size_t>(j)]) +=
          factor * a(i) * b(j);
    }
  }
}

void AddProduct(const Quadratic& a, const Linear& b, Cubic* sum) {
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 4; ++j) {
      (*sum)(kQuadraticTimesLinear[static_cast<size_t>(i)][static_cast<size_t>(j)]) += a(i) * b(j);
    }
  }
}

// E = x X + y Y + z Z + W entry by entry, from the null space of the five epipolar equations.
using LinearMatrix = std::array<std::array<Linear, 3>, 3>;
using NullSpace = Eigen::Matrix<double, 9, 4>;

NullSpace FindNullSpace(const std::vector<Eigen::Vector2d>& points_a,
                        const std::vector<Eigen::Vector2d>& points_b) {
  Eigen::Matrix<double, 9, 5> equations;
  for (size_t i = 0; i < 5; ++i) {
    const Eigen::Vector3d x_a = points_a[i].homogeneous();
    equations.col(static_cast<int>(i)) << points_b[i].x() * x_a, points_b[i].y() * x_a, x_a;
  }
  const Eigen::HouseholderQR<Eigen::Matrix<double, 9, 5>> qr(equations);
  NullSpace last_columns = NullSpace::Zero();
  last_columns.bottomRows<4>().setIdentity();
  last_columns.applyOnTheLeft(qr.householderQ());
  return last_columns;
}

LinearMatrix MakeLinearMatrix(const NullSpace& null_space) {
  LinearMatrix matrix;
  for (int i = 0; i < 9; ++i) {
    matrix[static_cast<size_t>(i / 3)][static_cast<size_t>(i % 3)] = null_space.row(i).transpose();
  }
  return matrix;
}

// det E = 0.
Cubic DeterminantConstraint(const LinearMatrix& e) {
  Cubic sum = Cubic::Zero();
  for (size_t k = 0; k < 3; ++k) {
    const size_t l = (k + 1) % 3, m = (k + 2) % 3;
    Quadratic minor = Quadratic::Zero();
    AddProduct(e[1][l], e[2][m], 1.0, &minor);
    AddProduct(e[1][m], e[2][l], -1.0, &minor);
    AddProduct(minor, e[0][k], &sum);
  }
  return sum;
}

using Constraints = Eigen::Matrix<double, 10, 20>;

// det E = 0 and (E E^T - trace(E E^T) / 2) E = 0.
Constraints BuildConstraints(const LinearMatrix& e) {
  std::array<std::array<Quadratic, 3>, 3> square;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j <= i; ++j) {
      square[i][j].setZero();
      for (size_t k = 0; k < 3; ++k) AddProduct(e[i][k], e[j][k], 1.0, &square[i][j]);
      square[j][i] = square[i][j];
    }
  }
  const Quadratic half_trace = 0.5 * (square[0][0] + square[1][1] + square[2][2]);
  for (size_t i = 0; i < 3; ++i) square[i][i] -= half_trace;
  Constraints constraints;
  constraints.row(0) = DeterminantConstraint(e).transpose();
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      Cubic sum = Cubic::Zero();
      for (size_t k = 0; k < 3; ++k) AddProduct(square[i][k], e[k][j], &sum);
      constraints.row(static_cast<int>(1 + 3 * i + j)) = sum.transpose();
    }
  }
  return constraints;
}

// A polynomial in z alone, lowest power first.
using InZ = std::array<double, 11>;

InZ Multiply(const InZ& a, int degree_a, const InZ& b, int degree_b) {
  InZ product{};
  for (int i = 0; i <= degree_a; ++i) {
    for (int j = 0; j <= degree_b; ++j) {
      product[static_cast<size_t>(i + j)] += a[static_cast<size_t>(i)] * b[static_cast<size_t>(j)];
    }
  }
  return product;
}

// Three equations (p x + q y + r) = 0 with p, q of degree 3 and r of degree 4 in z.
using MatrixInZ = std::array<std::array<InZ, 3>, 3>;
constexpr std::array<int, 3> kDegrees = {3, 3, 4};

// row(x^2 z) - z row(x^2) and its like; eliminated holds what is right of the identity.
MatrixInZ BuildMatrixInZ(const Eigen::Matrix<double, 10, 10>& eliminated) {
  MatrixInZ matrix{};
  for (int i = 0; i < 3; ++i) {
    const auto with_z = eliminated.row(4 + 2 * i), without_z = eliminated.row(5 + 2 * i);
    for (int k = 0, column = 0; k < 3; ++k) {
      const int count = kDegrees[static_cast<size_t>(k)];
      InZ& entry = matrix[static_cast<size_t>(i)][static_cast<size_t>(k)];
      for (int power = count - 1; power >= 0; --power, ++column) {
        entry[static_cast<size_t>(power)] += with_z(column);
        entry[static_cast<size_t>(power + 1)] -= without_z(column);
      }
    }
  }
  return matrix;
}

std::vector<double> Determinant(const MatrixInZ& m) {
  std::vector<double> sum(11, 0.0);
  for (size_t k = 0; k < 3; ++k) {
    const size_t p = (k + 1) % 3, q = (k + 2) % 3;
    const int minor_degree = kDegrees[p] + kDegrees[q];
    InZ minor = Multiply(m[1][p], kDegrees[p], m[2][q], kDegrees[q]);
    const InZ other = Multiply(m[1][q], kDegrees[q], m[2][p], kDegrees[p]);
    for (size_t i = 0; i < minor.size(); ++i) minor[i] -= other[i];
    const InZ product = Multiply(minor, minor_degree, m[0][k], kDegrees[k]);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += product[i];
  }
  return sum;
}

// (x, y, 1) up to scale: the null vector of the matrix at z, from its two most independent rows.
Eigen::Vector3d SolveForXY(const MatrixInZ& matrix, double z) {
  Eigen::Matrix3d value;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      double sum = 0.0;
      for (int power = kDegrees[k]; power >= 0; --power) {
        sum = sum * z + matrix[i][k][static_cast<size_t>(power)];
      }
      value(static_cast<int>(i), static_cast<int>(k)) = sum;
    }
  }
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d null = value.row(i).cross(value.row((i + 1) % 3)).transpose();
    if (null.squaredNorm() > best.squaredNorm()) best = null;
  }
  return best;
}

}  // namespace

std::vector<Eigen::Matrix3d> SolveFivePoint(const std::vector<Eigen::Vector2d>& points_a,
                                            const std::vector<Eigen::Vector2d>& points_b) {
  ROVIO_CHECK(points_a.size() == 5 && points_b.size() == 5);
  const NullSpace null_space = FindNullSpace(points_a, points_b);
  const Constraints constraints = BuildConstraints(MakeLinearMatrix(null_space));
  const Eigen::PartialPivLU<Eigen::Matrix<double, 10, 10>> lu(constraints.leftCols<10>());
  const Eigen::Matrix<double, 10, 10> eliminated = lu.solve(constraints.rightCols<10>());
  if (!eliminated.allFinite()) return {};
  const MatrixInZ matrix = BuildMatrixInZ(eliminated);
  std::vector<Eigen::Matrix3d> essentials;
  for (const double z : FindRealRoots(Determinant(matrix))) {
    const Eigen::Vector3d xy1 = SolveForXY(matrix, z);
    if (!(std::abs(xy1.z()) > 1e-12 * xy1.norm())) continue;
    const Eigen::Vector4d weights(xy1.x() / xy1.z(), xy1.y() / xy1.z(), z, 1.0);
    const Eigen::Matrix<double, 9, 1> stack = (null_space * weights).normalized() * std::sqrt(2.0);
    essentials.push_back(
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(stack.data()));
  }
  return essentials;
}

}  // namespace rovio_sfm
