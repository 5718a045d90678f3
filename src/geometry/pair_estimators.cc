#include "rovio_sfm/geometry/pair_estimators.h"

#include <algorithm>

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/geometry/five_point.h"
#include "rovio_sfm/geometry/homography.h"
#include "rovio_sfm/geometry/relative_pose.h"

namespace rovio_sfm {
namespace {

constexpr int kLocalSteps = 4;  // of the non-linear refinement inside RANSAC
constexpr int kBlockSize = 64;  // data whose loss is summed before the bound is looked at
constexpr float kTinyNorm = 1e-20f;

}  // namespace

PointPairs PointPairs::Select(const std::vector<uint32_t>& indices) const {
  PointPairs selected;
  selected.a.reserve(indices.size());
  selected.b.reserve(indices.size());
  for (const uint32_t i : indices) {
    selected.a.push_back(a[i]);
    selected.b.push_back(b[i]);
  }
  return selected;
}

EssentialEstimator::EssentialEstimator(const PointPairs& points)
    : points_(points),
      x_a_(points.a.size()),
      y_a_(points.a.size()),
      x_b_(points.a.size()),
      y_b_(points.a.size()) {
  for (uint32_t i = 0; i < points.Count(); ++i) {
    x_a_(i) = static_cast<float>(points.a[i].x());
    y_a_(i) = static_cast<float>(points.a[i].y());
    x_b_(i) = static_cast<float>(points.b[i].x());
    y_b_(i) = static_cast<float>(points.b[i].y());
  }
}

std::vector<Eigen::Matrix3d> EssentialEstimator::Solve(const std::vector<uint32_t>& sample) const {
  const PointPairs selected = points_.Select(sample);
  return SolveFivePoint(selected.a, selected.b);
}

double EssentialEstimator::SquaredResidual(const Eigen::Matrix3d& essential, uint32_t i) const {
  return SquaredSampsonError(essential, points_.a[i], points_.b[i]);
}

std::optional<Eigen::Matrix3d> EssentialEstimator::Refine(
    const Eigen::Matrix3d& essential, const std::vector<uint32_t>& inliers) const {
  const PointPairs selected = points_.Select(inliers);
  // The Sampson error is the same for all four poses of an essential matrix.
  const auto pose = RefineRelativePose(selected.a, selected.b,
                                       DecomposeEssential(essential).front(), kLocalSteps);
  if (!pose) return std::nullopt;
  return EssentialFromPose(*pose);
}

double EssentialEstimator::TruncatedLoss(const Eigen::Matrix3d& essential, double squared_threshold,
                                         double bound) const {
  using Block = Eigen::Array<float, Eigen::Dynamic, 1, 0, kBlockSize, 1>;
  const Eigen::Matrix3f e = essential.cast<float>();
  const float scale = static_cast<float>(1.0 / squared_threshold);
  double sum = 0.0;
  for (Eigen::Index first = 0; first < x_a_.size() && sum <= bound; first += kBlockSize) {
    const Eigen::Index count = std::min<Eigen::Index>(kBlockSize, x_a_.size() - first);
    const auto x_a = x_a_.segment(first, count), y_a = y_a_.segment(first, count);
    const auto x_b = x_b_.segment(first, count), y_b = y_b_.segment(first, count);
    const Block line_b_x = e(0, 0) * x_a + e(0, 1) * y_a + e(0, 2);
    const Block line_b_y = e(1, 0) * x_a + e(1, 1) * y_a + e(1, 2);
    const Block residual =
        x_b * line_b_x + y_b * line_b_y + e(2, 0) * x_a + e(2, 1) * y_a + e(2, 2);
    const Block squared_norm = line_b_x.square() + line_b_y.square() +
                               (e(0, 0) * x_b + e(1, 0) * y_b + e(2, 0)).square() +
                               (e(0, 1) * x_b + e(1, 1) * y_b + e(2, 1)).square() + kTinyNorm;
    sum += static_cast<double>((scale * residual.square() / squared_norm).min(1.0f).sum());
  }
  return sum;
}

std::vector<Eigen::Matrix3d> HomographyEstimator::Solve(const std::vector<uint32_t>& sample) const {
  const PointPairs selected = points_.Select(sample);
  const auto homography = SolveFourPoint(selected.a, selected.b);
  if (!homography) return {};
  return {*homography};
}

double HomographyEstimator::SquaredResidual(const Eigen::Matrix3d& homography, uint32_t i) const {
  return SquaredTransferError(homography, points_.a[i], points_.b[i]);
}

std::optional<Eigen::Matrix3d> HomographyEstimator::Refine(
    const Eigen::Matrix3d& homography, const std::vector<uint32_t>& inliers) const {
  const PointPairs selected = points_.Select(inliers);
  return RefineHomography(selected.a, selected.b, homography, kLocalSteps);
}

}  // namespace rovio_sfm
