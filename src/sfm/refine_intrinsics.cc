#include "rovio_sfm/sfm/refine_intrinsics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

constexpr double kChance = 7.8;              // chi-squared of three, exceeded once in 20 times
constexpr double kAlike = 5.0;               // features of a track err alike: so many count as one
constexpr size_t kMaxObservations = 80'000;  // tell well enough whether a camera is right
constexpr size_t kGlance = 20'000;           // tell that a correction is out of all belief
constexpr size_t kWorthAGlance = 60'000;     // with fewer, the glance costs more than it spares
constexpr int kMaxIterations = 10;
constexpr double kTolerance = 1e-6;  // little of the cost tells of a correction

// Of a coordinate of a residual, in sigmas, as far as the robust loss lets it count, for as many
// independent ones as there are.
double Variance(const BundleProblem& problem, double loss_sigmas) {
  double sum = 0.0;
  for (const BundleObservation& observation : problem.observations) {
    const auto error =
        ReprojectionError(problem.cameras[observation.camera].cam_from_map,
                          observation.x_normalized, problem.points[observation.point]);
    if (!error) continue;  // behind the camera: the problem will not be usable
    const double squared = std::pow(*error / observation.sigma, 2);
    const double scale = loss_sigmas * loss_sigmas;
    sum += scale > 0.0 ? scale * std::log1p(squared / scale) : squared;
  }
  return kAlike * 0.5 * sum / static_cast<double>(problem.observations.size());
}

// Sigmas of observations say how they compare to each other, the variance how to anything else.
void ScaleSigmas(double factor, BundleProblem* problem) {
  for (BundleIntrinsics& intrinsics : problem->intrinsics) intrinsics.sigma *= factor;
}

bool AreBelievable(const std::vector<BundleIntrinsics>& all) {
  return std::all_of(all.begin(), all.end(), [](const BundleIntrinsics& intrinsics) {
    const Eigen::Vector3d strangeness =
        (intrinsics.correction - intrinsics.expected).cwiseQuotient(intrinsics.sigma);
    return strangeness.squaredNorm() <= kChance;
  });
}

// Solves, and returns how much the cost fell; nothing where that is not usable.
std::optional<double> Gain(const BundleOptions& options, double variance, BundleProblem* problem) {
  BundleOptions solve = options;
  solve.max_iterations = std::min(options.max_iterations, kMaxIterations);
  solve.function_tolerance = kTolerance;
  ScaleSigmas(1.0 / std::sqrt(variance), problem);
  const BundleReport report = AdjustBundle(problem, solve);
  ScaleSigmas(std::sqrt(variance), problem);
  if (!report.usable) return std::nullopt;
  return report.initial_cost - report.final_cost;
}

// With every so-manieth point only, where there are more observations than wanted.
BundleProblem Thinned(const BundleProblem& problem, size_t max_observations) {
  const size_t step = problem.observations.size() / max_observations + 1;
  if (step == 1) return problem;
  BundleProblem thinned{problem.cameras, {}, {}, problem.intrinsics};
  for (size_t i = 0; i < problem.points.size(); i += step) {
    thinned.points.push_back(problem.points[i]);
  }
  for (BundleObservation observation : problem.observations) {
    if (observation.point % step != 0) continue;
    observation.point /= static_cast<uint32_t>(step);
    thinned.observations.push_back(observation);
  }
  return thinned;
}

// The later half of each camera's pictures gets intrinsics of its own.
BundleProblem Halved(const BundleProblem& problem) {
  BundleProblem halved = problem;
  const size_t num_intrinsics = problem.intrinsics.size();
  std::vector<size_t> num_cameras(num_intrinsics), num_seen(num_intrinsics);
  for (const BundleCamera& camera : problem.cameras) ++num_cameras[camera.intrinsics];
  for (BundleCamera& camera : halved.cameras) {
    const uint32_t intrinsics = camera.intrinsics;
    const bool is_late = 2 * num_seen[intrinsics]++ >= num_cameras[intrinsics];
    if (is_late) camera.intrinsics += static_cast<uint32_t>(num_intrinsics);
  }
  halved.intrinsics.insert(halved.intrinsics.end(), problem.intrinsics.begin(),
                           problem.intrinsics.end());
  return halved;
}

// Whether a solution is so much better than another problem's that chance alone does not make it.
bool IsEvident(const std::optional<double>& gain, double variance) {
  return gain && 2.0 * *gain >= kChance * variance;
}

// A part of the points shows at little cost where the corrections are out of all belief, as where
// it is not the camera that is wrong.
bool PassesGlance(const BundleOptions& options, double variance, const BundleProblem& problem) {
  if (problem.observations.size() < kWorthAGlance) return true;
  BundleProblem glance = Thinned(problem, kGlance);
  return Gain(options, variance, &glance) && AreBelievable(glance.intrinsics);
}

}  // namespace

bool RefineIntrinsics(const BundleOptions& options, BundleProblem* problem) {
  if (problem->intrinsics.empty() || problem->observations.empty()) return false;
  const double variance = Variance(*problem, options.loss_sigmas);
  if (!(variance > 0.0) || !PassesGlance(options, variance, *problem)) return false;
  BundleProblem trial = Thinned(*problem, kMaxObservations);
  if (!IsEvident(Gain(options, variance, &trial), variance) || !AreBelievable(trial.intrinsics)) {
    return false;
  }
  BundleProblem halved = Halved(trial);
  const auto gain_of_halves = Gain(options, variance, &halved);
  if (!gain_of_halves || IsEvident(gain_of_halves, variance)) return false;
  if (trial.points.size() < problem->points.size()) {
    BundleProblem whole = *problem;
    whole.intrinsics = trial.intrinsics;
    if (!Gain(options, variance, &whole)) return false;
    trial = std::move(whole);
  }
  *problem = std::move(trial);
  return true;
}

}  // namespace rovio_sfm
