#include "rovio_sfm/geometry/pair_estimators.h"

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/geometry/five_point.h"
#include "rovio_sfm/geometry/homography.h"
#include "rovio_sfm/geometry/relative_pose.h"

namespace rovio_sfm {
namespace {

constexpr int kLocalSteps = 4;  // of the non-linear refinement inside RANSAC

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

std::vector<Eigen::Matrix3d> HomographyEstimator::Solve(const std::vector<uint32_t>& sample) const {
  const PointPairs selected = points_.Select(sample);
  const auto homography = EstimateHomography(selected.a, selected.b);
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
