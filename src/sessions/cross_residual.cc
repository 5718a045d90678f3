#include "rovio_sfm/sessions/cross_residual.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

constexpr double kMinDepth = 1e-9;

// A landmark of one session in the frame of the other; lengths are those of the other.
struct Transfer {
  Eigen::Vector3d x_in_cam;  // the landmark
  Eigen::Vector3d ray;       // from its own frame's centre to the landmark, in the other frame
};

std::optional<Transfer> TransferLandmark(const CrossView& from, const CrossView& to,
                                         const Sim3& to_from_from) {
  const Eigen::Vector3d x = to.cam_from_session * (to_from_from * from.landmark->position);
  if (!(x.z() > kMinDepth)) return std::nullopt;
  const Eigen::Vector3d center =
      to.cam_from_session * (to_from_from * OriginInA(from.cam_from_session));
  return Transfer{x, x - center};
}

double SigmaLogDistance(const CrossView& view, double floor) {
  return std::hypot(view.landmark->sigma_log_distance, floor);
}

// The inverse root of the covariance: both features' sigmas in all directions, the distance's along
// the epipolar line.
Eigen::Matrix2d Whiten(const CrossView& from, const CrossView& to, const Transfer& transfer,
                       double floor) {
  const Eigen::Vector3d& x = transfer.x_in_cam;
  Eigen::Matrix<double, 2, 3> projection;
  projection << 1, 0, -x.x() / x.z(), 0, 1, -x.y() / x.z();
  const double spread = SigmaLogDistance(from, floor) * (projection * transfer.ray / x.z()).norm();
  const Eigen::Vector2d along = (projection * transfer.ray).stableNormalized();
  const double sigma = std::hypot(to.sigma, from.sigma * transfer.ray.norm() / x.norm());
  const double weight_across = 1.0 / sigma, weight_along = 1.0 / std::hypot(sigma, spread);
  return weight_across * Eigen::Matrix2d::Identity() +
         (weight_along - weight_across) * along * along.transpose();
}

}  // namespace

std::optional<CrossWeights> WeighMatch(const CrossMatch& match, const Sim3& b_from_a,
                                       double sigma_log_distance_floor) {
  if (!match.a.landmark && !match.b.landmark) return std::nullopt;
  CrossWeights weights;
  if (match.a.landmark) {
    const auto transfer = TransferLandmark(match.a, match.b, b_from_a);
    if (!transfer) return std::nullopt;
    weights.a_in_b = Whiten(match.a, match.b, *transfer, sigma_log_distance_floor);
  }
  if (match.b.landmark) {
    const auto transfer = TransferLandmark(match.b, match.a, Inverse(b_from_a));
    if (!transfer) return std::nullopt;
    weights.b_in_a = Whiten(match.b, match.a, *transfer, sigma_log_distance_floor);
  }
  if (IsCommon(match)) {
    weights.log_depth = 1.0 / std::hypot(SigmaLogDistance(match.a, sigma_log_distance_floor),
                                         SigmaLogDistance(match.b, sigma_log_distance_floor));
  }
  return weights;
}

double CrossResidual::SquaredMax() const {
  double largest = 0.0;
  if (a_in_b) largest = std::max(largest, a_in_b->squaredNorm());
  if (b_in_a) largest = std::max(largest, b_in_a->squaredNorm());
  if (log_depth) largest = std::max(largest, *log_depth * *log_depth);
  return largest;
}

double CrossResidual::SquaredSum() const {
  double sum = 0.0;
  if (a_in_b) sum += a_in_b->squaredNorm();
  if (b_in_a) sum += b_in_a->squaredNorm();
  if (log_depth) sum += *log_depth * *log_depth;
  return sum;
}

int CrossResidual::NumComponents() const {
  return (a_in_b ? 2 : 0) + (b_in_a ? 2 : 0) + (log_depth ? 1 : 0);
}

std::optional<CrossResidual> ResidualOf(const CrossMatch& match, const Sim3& b_from_a,
                                        double sigma_log_distance_floor) {
  const auto weights = WeighMatch(match, b_from_a, sigma_log_distance_floor);
  if (!weights) return std::nullopt;
  CrossResidual residual;
  Eigen::Vector3d a_in_cam_b = Eigen::Vector3d::Zero();
  if (weights->a_in_b) {
    a_in_cam_b = match.b.cam_from_session * (b_from_a * match.a.landmark->position);
    residual.a_in_b = *weights->a_in_b * (a_in_cam_b.hnormalized() - match.b.x_normalized);
  }
  if (weights->b_in_a) {
    const Eigen::Vector3d x =
        match.a.cam_from_session * (Inverse(b_from_a) * match.b.landmark->position);
    residual.b_in_a = *weights->b_in_a * (x.hnormalized() - match.a.x_normalized);
  }
  if (weights->log_depth) {
    const Eigen::Vector3d b_in_cam_b = match.b.cam_from_session * match.b.landmark->position;
    if (!(b_in_cam_b.z() > kMinDepth)) return std::nullopt;
    residual.log_depth = *weights->log_depth * std::log(a_in_cam_b.z() / b_in_cam_b.z());
  }
  return residual;
}

}  // namespace rovio_sfm
