#include "rovio_sfm/sfm/resect_frame.h"

#include <limits>
#include <opencv2/calib3d.hpp>

#include "rovio_sfm/geometry/ransac.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kMinInliers = 6;

double SquaredResidualSigmas(const PoseObservation& observation, const Rigid3& cam_from_map) {
  const Eigen::Vector3d x = cam_from_map * observation.point;
  if (!(x.z() > 1e-9)) return std::numeric_limits<double>::infinity();
  return (x.hnormalized() - observation.x_normalized).squaredNorm() /
         (observation.sigma * observation.sigma);
}

std::vector<PoseObservation> Select(const std::vector<PoseObservation>& observations,
                                    const std::vector<uint32_t>& chosen) {
  std::vector<PoseObservation> selected;
  for (const uint32_t i : chosen) selected.push_back(observations[i]);
  return selected;
}

std::optional<Rigid3> SolveEpnp(const std::vector<PoseObservation>& observations) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const PoseObservation& observation : observations) {
    points.emplace_back(observation.point.x(), observation.point.y(), observation.point.z());
    pixels.emplace_back(observation.x_normalized.x(), observation.x_normalized.y());
  }
  cv::Vec3d turn, shift;
  if (!cv::solvePnP(points, pixels, cv::Matx33d::eye(), cv::noArray(), turn, shift, false,
                    cv::SOLVEPNP_EPNP)) {
    return std::nullopt;
  }
  const Eigen::Vector3d w(turn[0], turn[1], turn[2]), t(shift[0], shift[1], shift[2]);
  if (!w.allFinite() || !t.allFinite()) return std::nullopt;
  const double angle = w.norm();
  const Eigen::AngleAxisd rotation(
      angle, angle > 0.0 ? Eigen::Vector3d(w / angle) : Eigen::Vector3d::UnitX());
  return Rigid3{Eigen::Quaterniond(rotation), t};
}

class PoseEstimator {
 public:
  using Model = Rigid3;
  static constexpr int kSampleSize = 5;

  PoseEstimator(const std::vector<PoseObservation>& observations, const ResectFrameOptions& options)
      : observations_(observations), refine_{5, options.loss_sigmas} {}

  uint32_t NumData() const { return static_cast<uint32_t>(observations_.size()); }

  std::vector<Model> Solve(const std::vector<uint32_t>& sample) const {
    const auto pose = SolveEpnp(Select(observations_, sample));
    return pose ? std::vector<Model>{*pose} : std::vector<Model>{};
  }

  double SquaredResidual(const Model& cam_from_map, uint32_t datum) const {
    return SquaredResidualSigmas(observations_[datum], cam_from_map);
  }

  std::optional<Model> Refine(const Model& cam_from_map,
                              const std::vector<uint32_t>& inliers) const {
    if (inliers.size() < kMinInliers) return std::nullopt;
    return RefinePose(Select(observations_, inliers), cam_from_map, refine_);
  }

 private:
  const std::vector<PoseObservation>& observations_;
  RefinePoseOptions refine_;
};

std::optional<Resection> RefineOnInliers(const std::vector<PoseObservation>& observations,
                                         const Rigid3& initial, std::vector<uint32_t> inliers,
                                         const ResectFrameOptions& options) {
  Resection resection{initial, std::move(inliers)};
  const double squared_threshold = options.threshold_sigmas * options.threshold_sigmas;
  for (int round = 0; round < 2; ++round) {
    if (resection.inliers.size() < kMinInliers) return std::nullopt;
    const auto pose = RefinePose(Select(observations, resection.inliers), resection.cam_from_map,
                                 {20, options.loss_sigmas});
    if (!pose) return std::nullopt;
    resection.cam_from_map = *pose;
    resection.inliers.clear();
    for (uint32_t i = 0; i < observations.size(); ++i) {
      const double squared = SquaredResidualSigmas(observations[i], *pose);
      if (squared < squared_threshold) resection.inliers.push_back(i);
    }
  }
  if (resection.inliers.size() < kMinInliers) return std::nullopt;
  return resection;
}

}  // namespace

std::optional<Resection> ResectFrame(const std::vector<PoseObservation>& observations,
                                     const ResectFrameOptions& options, Rng& rng) {
  RansacOptions ransac;
  ransac.threshold = options.threshold_sigmas;
  ransac.max_iterations = options.max_iterations;
  const auto report = Ransac(PoseEstimator(observations, options), ransac, rng);
  if (!report) return std::nullopt;
  return RefineOnInliers(observations, report->model, report->inliers, options);
}

std::optional<Resection> ResectFromPrediction(const std::vector<PoseObservation>& observations,
                                              const Rigid3& predicted_cam_from_map,
                                              const ResectFrameOptions& options) {
  const auto pose = RefinePose(observations, predicted_cam_from_map, {20, options.loss_sigmas});
  if (!pose) return std::nullopt;
  std::vector<uint32_t> inliers;
  const double squared_threshold = options.threshold_sigmas * options.threshold_sigmas;
  for (uint32_t i = 0; i < observations.size(); ++i) {
    if (SquaredResidualSigmas(observations[i], *pose) < squared_threshold) inliers.push_back(i);
  }
  return RefineOnInliers(observations, *pose, std::move(inliers), options);
}

}  // namespace rovio_sfm
