#include "rovio_sfm/geometry/sim3.h"

#include <Eigen/SVD>

namespace rovio_sfm {
namespace {

constexpr double kMinSpread = 1e-9;  // smallest second singular value, relative to the first

Eigen::Vector3d Mean(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

}  // namespace

std::optional<Sim3> AlignPoints(const std::vector<Eigen::Vector3d>& points_in_a,
                                const std::vector<Eigen::Vector3d>& points_in_b) {
  if (points_in_a.size() < 3 || points_in_a.size() != points_in_b.size()) return std::nullopt;
  const Eigen::Vector3d mean_a = Mean(points_in_a), mean_b = Mean(points_in_b);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double variance_a = 0.0;
  for (size_t i = 0; i < points_in_a.size(); ++i) {
    const Eigen::Vector3d a = points_in_a[i] - mean_a;
    covariance += (points_in_b[i] - mean_b) * a.transpose();
    variance_a += a.squaredNorm();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d values = svd.singularValues();
  if (!(variance_a > 0.0) || !(values(1) > kMinSpread * values(0))) return std::nullopt;
  Eigen::Vector3d sign = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) sign(2) = -1.0;
  Sim3 b_from_a;
  b_from_a.rotation =
      Eigen::Quaterniond(svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose());
  b_from_a.scale = values.dot(sign) / variance_a;
  b_from_a.translation = mean_b - b_from_a.scale * (b_from_a.rotation * mean_a);
  return b_from_a;
}

}  // namespace rovio_sfm
