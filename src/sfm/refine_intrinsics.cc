#include "rovio_sfm/sfm/refine_intrinsics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rovio_sfm {
namespace {

constexpr double kChance = 7.8;  // chi-squared of three, exceeded once in 20 times
constexpr double kAlike = 5.0;   // features of a track err alike: so many count as one
constexpr int kMaxIterations = 10;

// Of a coordinate of a residual, in sigmas, as far as the robust loss lets it count, for as many
// independent ones as there are.
double Variance(const BundleProblem& problem, double loss_sigmas) {
  double sum = 0.0;
  for (const BundleObservation& observation : problem.observations) {
    const Rigid3& cam_from_map = problem.cameras[observation.camera].cam_from_map;
    const Eigen::Vector2d projection =
        (cam_from_map * problem.points[observation.point]).hnormalized();
    const double squared =
        ((projection - observation.x_normalized) / observation.sigma).squaredNorm();
    const double scale = loss_sigmas * loss_sigmas;
    sum += scale > 0.0 ? scale * std::log1p(squared / scale) : squared;
  }
  return kAlike * 0.5 * sum / static_cast<double>(problem.observations.size());
}

// Sigmas of observations say how they compare to each other, the variance how to anything else.
void ScaleSigmas(double factor, BundleProblem* problem) {
  for (BundleIntrinsics& intrinsics : problem->intrinsics) intrinsics.sigma *= factor;
}

bool IsBelievable(const BundleIntrinsics& intrinsics) {
  const Eigen::Vector3d strangeness =
      (intrinsics.correction - intrinsics.expected).cwiseQuotient(intrinsics.sigma);
  return strangeness.squaredNorm() <= kChance;
}

}  // namespace

bool RefineIntrinsics(const BundleOptions& options, BundleProblem* problem) {
  if (problem->intrinsics.empty() || problem->observations.empty()) return false;
  const double variance = Variance(*problem, options.loss_sigmas);
  if (!(variance > 0.0)) return false;
  BundleOptions solve = options;
  solve.max_iterations = std::min(options.max_iterations, kMaxIterations);
  BundleProblem refined = *problem;
  ScaleSigmas(1.0 / std::sqrt(variance), &refined);
  const BundleReport report = AdjustBundle(&refined, solve);
  ScaleSigmas(std::sqrt(variance), &refined);
  const double gain = report.initial_cost - report.final_cost;
  if (!report.usable || 2.0 * gain < kChance * variance ||
      !std::all_of(refined.intrinsics.begin(), refined.intrinsics.end(), IsBelievable)) {
    return false;
  }
  *problem = std::move(refined);
  return true;
}

}  // namespace rovio_sfm
