#include "rovio_sfm/sfm/odometry_gains.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace rovio_sfm {
namespace {

constexpr double kMinDistance_m = 0.3;
constexpr double kMinExplained = 0.5;  // of the variance where a gain has most effect

// The variance along the line from the first sample, and what of it each cause brings per unit:
// forward gain², sideways gain², noise. All relative to the distance squared.
struct VarianceRow {
  Eigen::Vector3d per_cause;
  double variance = 0.0;
};

Eigen::Matrix2d PlanarCovariance(const OdometrySample& sample) {
  const OdometryCovariance& c = *sample.covariance;
  return (Eigen::Matrix2d() << c[0], c[1], c[3], c[4]).finished();
}

std::vector<VarianceRow> MakeRows(const std::vector<OdometrySample>& samples) {
  std::vector<VarianceRow> rows;
  Eigen::Vector2d forward = Eigen::Vector2d::Zero(), sideways = Eigen::Vector2d::Zero();
  double path_m = 0.0;
  for (size_t k = 1; k < samples.size(); ++k) {
    const OdometrySample &first = samples.front(), &from = samples[k - 1], &to = samples[k];
    const Eigen::Vector2d step(to.x_m - from.x_m, to.y_m - from.y_m);
    const double yaw_rad = 0.5 * (from.yaw_rad + to.yaw_rad);
    const Eigen::Vector2d heading(std::cos(yaw_rad), std::sin(yaw_rad));
    forward += step.dot(heading) * heading;
    sideways += step - step.dot(heading) * heading;
    path_m += step.norm();
    const Eigen::Vector2d moved(to.x_m - first.x_m, to.y_m - first.y_m);
    if (moved.norm() < kMinDistance_m) continue;
    const Eigen::Vector2d along = moved.normalized();
    const double variance = along.dot((PlanarCovariance(to) - PlanarCovariance(first)) * along);
    const Eigen::Vector3d per_cause(std::pow(along.dot(forward), 2),
                                    std::pow(along.dot(sideways), 2), path_m);
    rows.push_back({per_cause / moved.squaredNorm(), variance / moved.squaredNorm()});
  }
  return rows;
}

// Least squares over those causes alone whose bit is set; the others are zero.
Eigen::Vector3d FitSubset(const Eigen::MatrixX3d& a, const Eigen::VectorXd& b, unsigned causes) {
  Eigen::MatrixX3d of_subset = a;
  for (int i = 0; i < 3; ++i) {
    if ((causes >> i & 1u) == 0) of_subset.col(i).setZero();
  }
  return of_subset.completeOrthogonalDecomposition().solve(b);
}

// Least squares with no cause below zero: of the 8 subsets the best that is allowed.
Eigen::Vector3d FitCauses(const std::vector<VarianceRow>& rows) {
  Eigen::MatrixX3d a(rows.size(), 3);
  Eigen::VectorXd b(rows.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    a.row(static_cast<Eigen::Index>(i)) = rows[i].per_cause.transpose();
    b[static_cast<Eigen::Index>(i)] = rows[i].variance;
  }
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (unsigned causes = 0; causes < 8; ++causes) {
    const Eigen::Vector3d fit = FitSubset(a, b, causes);
    const double residual = (a * fit - b).squaredNorm();
    if (fit.minCoeff() < 0.0 || !(residual < least)) continue;
    least = residual, best = fit;
  }
  return best;
}

// Nothing unless the cause explains most of the variance of the samples where it is the larger of
// both gains.
std::optional<double> ToldGain(const std::vector<VarianceRow>& rows, const Eigen::Vector3d& fit,
                               int cause) {
  double explained = 0.0, total = 0.0;
  for (const VarianceRow& row : rows) {
    if (row.per_cause[cause] < row.per_cause[1 - cause]) continue;
    explained += fit[cause] * row.per_cause[cause];
    total += row.variance;
  }
  if (!(total > 0.0) || explained < kMinExplained * total) return std::nullopt;
  return std::sqrt(fit[cause]);
}

}  // namespace

OdometryGains LearnOdometryGains(const std::vector<OdometrySample>& samples,
                                 const OdometryGains& least) {
  const bool all_known = std::all_of(samples.begin(), samples.end(),
                                     [](const auto& s) { return s.covariance.has_value(); });
  if (!all_known) return least;
  const std::vector<VarianceRow> rows = MakeRows(samples);
  if (rows.empty()) return least;
  const Eigen::Vector3d fit = FitCauses(rows);
  const double forward = ToldGain(rows, fit, 0).value_or(least.forward_sigma);
  const double sideways = ToldGain(rows, fit, 1).value_or(least.sideways_sigma);
  return {std::max(forward, least.forward_sigma), std::max(sideways, least.forward_sigma)};
}

}  // namespace rovio_sfm
