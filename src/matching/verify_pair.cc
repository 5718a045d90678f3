#include "rovio_sfm/matching/verify_pair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/geometry/homography.h"
#include "rovio_sfm/geometry/pair_estimators.h"
#include "rovio_sfm/geometry/ransac.h"
#include "rovio_sfm/geometry/relative_pose.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr int kMaxRefineSteps = 10;
constexpr double kLossScale = 0.67;  // of Cauchy's loss, in thresholds

// Thresholds on the plane z = 1, and the matches sorted for PROSAC.
struct PairProblem {
  const VerifyPairOptions& options;
  double focal_px = 0.0;
  std::vector<uint32_t> order;  // order[i]: index of the match that is points' element i
  PointPairs points;

  double Threshold() const { return options.threshold_px / focal_px; }
};

PairProblem MakeProblem(const std::vector<Eigen::Vector2d>& points_a,
                        const std::vector<Eigen::Vector2d>& points_b,
                        const std::vector<FeatureMatch>& matches, double focal_px,
                        const VerifyPairOptions& options) {
  PairProblem problem{options, focal_px, std::vector<uint32_t>(matches.size()), {}};
  std::iota(problem.order.begin(), problem.order.end(), 0u);
  std::stable_sort(problem.order.begin(), problem.order.end(),
                   [&](uint32_t i, uint32_t j) { return matches[i].ratio < matches[j].ratio; });
  for (const uint32_t i : problem.order) {
    ROVIO_CHECK(matches[i].a < points_a.size() && matches[i].b < points_b.size());
    problem.points.a.push_back(points_a[matches[i].a]);
    problem.points.b.push_back(points_b[matches[i].b]);
  }
  return problem;
}

RansacOptions MakeRansacOptions(const PairProblem& problem) {
  RansacOptions options;
  options.max_iterations = problem.options.max_iterations;
  options.min_iterations = std::min(problem.options.min_iterations, options.max_iterations);
  options.confidence = problem.options.confidence;
  options.threshold = problem.Threshold();
  options.prosac_samples = problem.options.prosac_samples;
  return options;
}

// 0 of nothing.
double MedianOf(std::vector<double> values) {
  return values.empty() ? 0.0 : Median(std::move(values));
}

// The matches whose squared residual is below the squared threshold.
template <typename Residual>
std::vector<uint32_t> SelectWithin(const PointPairs& points, double threshold, Residual residual) {
  std::vector<uint32_t> selected;
  for (uint32_t i = 0; i < points.Count(); ++i) {
    if (residual(points.a[i], points.b[i]) < threshold * threshold) selected.push_back(i);
  }
  return selected;
}

// The distance of each match from a pure rotation, on the plane z = 1.
std::vector<double> RotationFlow(const PointPairs& points, const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  std::vector<double> flow(points.Count());
  for (uint32_t i = 0; i < points.Count(); ++i) {
    flow[i] = std::sqrt(2.0 * SquaredTransferError(matrix, points.a[i], points.b[i]));
  }
  return flow;
}

// The least-squares rotation, fitted again to the half of the matches it explains best.
std::optional<Eigen::Quaterniond> EstimateRotationRobustly(const PointPairs& points) {
  auto rotation = EstimateRotation(points.a, points.b);
  for (int round = 0; rotation && round < 2; ++round) {
    const std::vector<double> flow = RotationFlow(points, *rotation);
    const double limit = 2.0 * MedianOf(flow);
    std::vector<uint32_t> near;
    for (uint32_t i = 0; i < points.Count(); ++i) {
      if (flow[i] <= limit) near.push_back(i);
    }
    const PointPairs selected = points.Select(near);
    rotation = EstimateRotation(selected.a, selected.b);
  }
  return rotation;
}

double MedianSampsonError(const PointPairs& points, const Eigen::Matrix3d& essential) {
  std::vector<double> errors(points.Count());
  for (uint32_t i = 0; i < points.Count(); ++i) {
    errors[i] = std::sqrt(SquaredSampsonError(essential, points.a[i], points.b[i]));
  }
  return MedianOf(std::move(errors));
}

// The angle between the rays of each match once the rotation is removed; its median.
double MedianParallax(const PointPairs& points, const Eigen::Quaterniond& rotation) {
  std::vector<double> angles(points.Count());
  for (uint32_t i = 0; i < points.Count(); ++i) {
    const Eigen::Vector3d ray_a = rotation * points.a[i].homogeneous();
    const Eigen::Vector3d ray_b = points.b[i].homogeneous();
    angles[i] = std::atan2(ray_a.cross(ray_b).norm(), ray_a.dot(ray_b));
  }
  return MedianOf(std::move(angles));
}

// H's share of the summed scores; a model's score here is what its truncated loss saves. H's
// threshold is larger as its residual has two degrees of freedom, not one (chi-square, 95 %).
double HomographyShare(const PairProblem& problem, const PointPairs& inliers, double essential_loss,
                       Rng& rng) {
  constexpr int kMaxIterations = 60;
  RansacOptions options = MakeRansacOptions(problem);
  options.max_iterations = std::min(options.max_iterations, kMaxIterations);
  options.min_iterations = std::min(options.min_iterations, options.max_iterations);
  options.prosac_samples = 0;
  options.threshold *= std::sqrt(5.99 / 3.84);
  const auto report = Ransac(HomographyEstimator(inliers), options, rng);
  const double homography_score = report ? inliers.Count() - report->score : 0.0;
  const double essential_score = inliers.Count() - essential_loss;
  const double sum = homography_score + essential_score;
  return sum > 0.0 ? homography_score / sum : 0.0;
}

// The pose of the five-point model, refined on all matches of twice the threshold with a robust
// loss: cutting the noise off at the threshold would bias it.
std::optional<Rigid3> RefinePose(const PairProblem& problem, const Rigid3& start) {
  const Eigen::Matrix3d essential = EssentialFromPose(start);
  const std::vector<uint32_t> selected =
      SelectWithin(problem.points, 2.0 * problem.Threshold(),
                   [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                     return SquaredSampsonError(essential, a, b);
                   });
  const PointPairs near = problem.points.Select(selected);
  return RefineRelativePose(near.a, near.b, start, kMaxRefineSteps,
                            kLossScale * problem.Threshold());
}

// The relative pose from the inliers of an essential matrix, by the method asked for.
std::optional<Rigid3> EstimatePose(const PairProblem& problem, const PointPairs& inliers,
                                   const Eigen::Matrix3d& essential) {
  if (problem.options.pose_method == PairPoseMethod::kAlgebraic) {
    const auto algebraic = EstimateAlgebraic(inliers.a, inliers.b);
    if (algebraic) return PoseFromEssential(*algebraic, inliers.a, inliers.b);
  }
  const auto pose = PoseFromEssential(essential, inliers.a, inliers.b);
  return pose ? RefinePose(problem, *pose) : std::nullopt;
}

bool IsRotation(const PairProblem& problem, double median_flow, double median_error) {
  const VerifyPairOptions& options = problem.options;
  return median_flow * problem.focal_px < options.min_flow_px ||
         median_flow < options.min_flow_noise_ratio * median_error;
}

// Fills in the result from the final inliers, given as elements of problem.points.
void FillResult(const PairProblem& problem, const std::vector<uint32_t>& selected,
                PairVerification* result) {
  if (selected.size() < static_cast<size_t>(problem.options.min_inliers)) {
    result->verdict = PairVerdict::kFailed;
    return;
  }
  result->median_parallax_rad =
      MedianParallax(problem.points.Select(selected), result->cam_b_from_cam_a.rotation);
  for (const uint32_t i : selected) result->inliers.push_back(problem.order[i]);
  std::sort(result->inliers.begin(), result->inliers.end());
}

// Inliers of a pure rotation obey it in both directions of the image, which refuses more outliers.
void FinishRotation(const PairProblem& problem, const Eigen::Quaterniond& rotation,
                    PairVerification* result) {
  const auto residual_of = [](const Eigen::Matrix3d& matrix) {
    return [matrix](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return SquaredTransferError(matrix, a, b);
    };
  };
  result->verdict = PairVerdict::kRotation;
  result->cam_b_from_cam_a = {rotation, Eigen::Vector3d::Zero()};
  // Twice the threshold: a little parallax is left even where the verdict is a rotation.
  const double threshold = 2.0 * problem.Threshold();
  std::vector<uint32_t> selected =
      SelectWithin(problem.points, threshold, residual_of(rotation.toRotationMatrix()));
  const PointPairs near = problem.points.Select(selected);
  if (const auto refined = EstimateRotation(near.a, near.b)) {
    result->cam_b_from_cam_a.rotation = *refined;
    selected = SelectWithin(problem.points, threshold, residual_of(refined->toRotationMatrix()));
  }
  FillResult(problem, selected, result);
}

void FinishTranslation(const PairProblem& problem, const PointPairs& inliers,
                       const Eigen::Matrix3d& essential, PairVerification* result) {
  const auto pose = EstimatePose(problem, inliers, essential);
  if (!pose) return;
  result->verdict = result->homography_share > problem.options.max_homography_share
                        ? PairVerdict::kPlanar
                        : PairVerdict::kGeneral;
  result->cam_b_from_cam_a = *pose;
  const Eigen::Matrix3d refined = EssentialFromPose(*pose);
  const std::vector<uint32_t> selected = SelectWithin(
      problem.points, problem.Threshold(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return IsInFront(*pose, a, b) ? SquaredSampsonError(refined, a, b) : 1e6;
      });
  FillResult(problem, selected, result);
}

}  // namespace

PairVerification VerifyPair(const std::vector<Eigen::Vector2d>& points_a,
                            const std::vector<Eigen::Vector2d>& points_b,
                            const std::vector<FeatureMatch>& matches, double focal_px,
                            const VerifyPairOptions& options, Rng& rng) {
  ROVIO_CHECK(focal_px > 0.0);
  PairVerification result;
  if (matches.size() < static_cast<size_t>(options.min_inliers)) return result;
  const PairProblem problem = MakeProblem(points_a, points_b, matches, focal_px, options);
  const auto report = Ransac(EssentialEstimator(problem.points), MakeRansacOptions(problem), rng);
  if (!report) return result;
  result.num_iterations = report->num_iterations;
  if (report->inliers.size() < static_cast<size_t>(options.min_inliers)) return result;
  const PointPairs inliers = problem.points.Select(report->inliers);
  const auto rotation = EstimateRotationRobustly(inliers);
  if (!rotation) return result;
  const double median_flow = MedianOf(RotationFlow(inliers, *rotation));
  result.median_flow_px = median_flow * focal_px;
  const double outlier_loss = problem.points.Count() - static_cast<double>(inliers.Count());
  result.homography_share = HomographyShare(problem, inliers, report->score - outlier_loss, rng);
  if (IsRotation(problem, median_flow, MedianSampsonError(inliers, report->model))) {
    FinishRotation(problem, *rotation, &result);
  } else {
    FinishTranslation(problem, inliers, report->model, &result);
  }
  return result;
}

}  // namespace rovio_sfm
