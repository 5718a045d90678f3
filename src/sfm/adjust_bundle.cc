#include "rovio_sfm/sfm/adjust_bundle.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "rovio_sfm/sfm/reprojection_cost.h"
#include "rovio_sfm/util/quiet_ceres.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxDenseCameras = 150;      // up to here a dense Schur complement is faster
constexpr size_t kMaxConnectedCameras = 600;  // their matrix takes 100 MB
constexpr double kMinConnectedShare = 0.25;
constexpr int kMinBoundIterations = 4;       // most of what there is to gain
constexpr size_t kMinSettlingCameras = 50;   // fewer: another iteration of all costs less
constexpr double kSettlingTolerance = 1e-4;  // as a share of the step's gain
// Poses and points nearly make up for a correction: what tells of it is lost in Ceres's damping.
constexpr double kWideRegion = 1e8;

PoseBlock ToBlock(const Rigid3& cam_from_map) {
  const auto& q = cam_from_map.rotation;
  const auto& t = cam_from_map.translation;
  return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()};
}

Rigid3 FromBlock(const PoseBlock& b) {
  return {Eigen::Quaterniond(b[3], b[0], b[1], b[2]).normalized(), {b[4], b[5], b[6]}};
}

// The cameras that hold the gauge, and the translation component that holds the scale.
struct Gauge {
  std::vector<bool> fixed;
  size_t scale_camera = 0;
  int scale_component = -1;
};

Gauge ChooseGauge(const BundleProblem& problem) {
  Gauge gauge;
  for (const BundleCamera& camera : problem.cameras) gauge.fixed.push_back(camera.fixed);
  const auto num_fixed = std::count(gauge.fixed.begin(), gauge.fixed.end(), true);
  if (num_fixed >= 2) return gauge;
  size_t origin = 0;
  if (num_fixed == 1) {
    origin = static_cast<size_t>(std::find(gauge.fixed.begin(), gauge.fixed.end(), true) -
                                 gauge.fixed.begin());
  }
  gauge.fixed[origin] = true;
  double widest = 0.0;
  const Eigen::Vector3d center = OriginInA(problem.cameras[origin].cam_from_map);
  for (size_t i = 0; i < problem.cameras.size(); ++i) {
    const Rigid3& pose = problem.cameras[i].cam_from_map;
    const double distance = (OriginInA(pose) - center).norm();
    if (distance <= widest) continue;
    widest = distance;
    gauge.scale_camera = i;
    // The component that moves most when the map grows about the first camera.
    (pose.rotation * (OriginInA(pose) - center)).cwiseAbs().maxCoeff(&gauge.scale_component);
  }
  return gauge;
}

using Costs = std::vector<std::unique_ptr<ceres::CostFunction>>;

ceres::CostFunction* CostOf(const BundleObservation& observation, const BundleProblem& problem) {
  const Eigen::Vector2d& seen = observation.x_normalized;
  if (problem.intrinsics.empty()) return MakeReprojectionCost(seen, observation.sigma);
  const uint32_t intrinsics = problem.cameras[observation.camera].intrinsics;
  const Camera& camera = problem.intrinsics[intrinsics].camera;
  return MakeUncalibratedCost(seen, observation.sigma, NormalizedByCorrection(camera, seen));
}

// Observations first, then intrinsics.
Costs CostsOf(const BundleProblem& problem) {
  Costs costs;
  costs.reserve(problem.observations.size());
  for (const BundleObservation& observation : problem.observations) {
    costs.emplace_back(CostOf(observation, problem));
  }
  for (const BundleIntrinsics& intrinsics : problem.intrinsics) {
    costs.emplace_back(MakeIntrinsicsCost(intrinsics.expected, intrinsics.sigma));
  }
  return costs;
}

// The costs and the loss stay the caller's: Ceres keeps no account of each.
ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  return options;
}

// What is solved for beside the points.
struct CameraBlocks {
  std::vector<PoseBlock> poses;
  std::vector<IntrinsicsBlock> intrinsics;
};

CameraBlocks BlocksOf(const BundleProblem& problem) {
  CameraBlocks blocks;
  for (const BundleCamera& camera : problem.cameras) {
    blocks.poses.push_back(ToBlock(camera.cam_from_map));
  }
  for (const BundleIntrinsics& intrinsics : problem.intrinsics) {
    const Eigen::Vector3d& correction = intrinsics.correction;
    blocks.intrinsics.push_back({correction[0], correction[1], correction[2]});
  }
  return blocks;
}

void TakeBlocks(const CameraBlocks& blocks, const Gauge& gauge, BundleProblem* problem) {
  for (size_t i = 0; i < blocks.poses.size(); ++i) {
    if (!gauge.fixed[i]) problem->cameras[i].cam_from_map = FromBlock(blocks.poses[i]);
  }
  for (size_t i = 0; i < blocks.intrinsics.size(); ++i) {
    problem->intrinsics[i].correction = Eigen::Vector3d(blocks.intrinsics[i].data());
  }
}

void AddObservations(BundleProblem* problem, ceres::LossFunction* loss, const Costs& costs,
                     CameraBlocks* blocks, ceres::Problem* solver) {
  const bool is_calibrated = blocks->intrinsics.empty();
  const size_t num_observations = problem->observations.size();
  for (size_t i = 0; i < num_observations; ++i) {
    const BundleObservation& observation = problem->observations[i];
    double* pose = blocks->poses[observation.camera].data();
    double* point = problem->points[observation.point].data();
    if (is_calibrated) {
      solver->AddResidualBlock(costs[i].get(), loss, pose, point);
    } else {
      const uint32_t intrinsics = problem->cameras[observation.camera].intrinsics;
      solver->AddResidualBlock(costs[i].get(), loss, pose, point,
                               blocks->intrinsics[intrinsics].data());
    }
  }
  for (size_t i = 0; i < blocks->intrinsics.size(); ++i) {
    solver->AddResidualBlock(costs[num_observations + i].get(), nullptr,
                             blocks->intrinsics[i].data());
  }
}

void SetGauge(const Gauge& gauge, std::vector<PoseBlock>* poses, ceres::Problem* solver) {
  for (size_t i = 0; i < poses->size(); ++i) {
    double* block = (*poses)[i].data();
    if (!solver->HasParameterBlock(block)) continue;
    const bool holds_scale = gauge.scale_component >= 0 && i == gauge.scale_camera;
    solver->SetManifold(block, MakePoseManifold(holds_scale ? gauge.scale_component : -1));
    if (gauge.fixed[i]) solver->SetParameterBlockConstant(block);
  }
}

// Points are eliminated first. Within a group Ceres goes by address, so poses and intrinsics, which
// the heap may put either way round, have a group each: same bytes every time.
std::shared_ptr<ceres::ParameterBlockOrdering> MakeOrdering(std::vector<Eigen::Vector3d>* points,
                                                            CameraBlocks* blocks,
                                                            const ceres::Problem& solver) {
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  const auto add = [&](double* block, int group) {
    if (solver.HasParameterBlock(block)) ordering->AddElementToGroup(block, group);
  };
  for (Eigen::Vector3d& point : *points) add(point.data(), 0);
  for (PoseBlock& pose : blocks->poses) add(pose.data(), 1);
  for (IntrinsicsBlock& intrinsics : blocks->intrinsics) add(intrinsics.data(), 2);
  return ordering;
}

// Under a robust loss the cameras are soon right and a few points crawl: alone they arrive at once.
void SettlePoints(ceres::Solver::Options* solver_options) {
  solver_options->use_inner_iterations = true;
  solver_options->inner_iteration_tolerance = kSettlingTolerance;
  auto alone = std::make_shared<ceres::ParameterBlockOrdering>();
  const auto& groups = solver_options->linear_solver_ordering->group_to_elements();
  for (double* point : groups.at(0)) alone->AddElementToGroup(point, 0);
  solver_options->inner_iteration_ordering = std::move(alone);
}

// Ends a solution that nobody waits for any more.
class GiveUp : public ceres::IterationCallback {
 public:
  explicit GiveUp(std::function<bool()> is_given_up) : is_given_up_(std::move(is_given_up)) {}
  bool Now() const { return is_given_up_ && is_given_up_(); }
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
    return Now() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  std::function<bool()> is_given_up_;
};

// Of the pairs of free cameras, those that see a point together.
double ConnectedShare(const BundleProblem& problem, const Gauge& gauge, size_t num_free) {
  std::vector<std::vector<uint32_t>> seen_by(problem.points.size());
  for (const BundleObservation& observation : problem.observations) {
    if (!gauge.fixed[observation.camera]) seen_by[observation.point].push_back(observation.camera);
  }
  const size_t num_cameras = problem.cameras.size();
  std::vector<bool> is_connected(num_cameras * num_cameras, false);
  size_t num_connected = 0;
  for (const std::vector<uint32_t>& cameras : seen_by) {
    for (const uint32_t a : cameras) {
      for (const uint32_t b : cameras) {
        if (a >= b || is_connected[a * num_cameras + b]) continue;
        is_connected[a * num_cameras + b] = true;
        ++num_connected;
      }
    }
  }
  return 2.0 * static_cast<double>(num_connected) /
         (static_cast<double>(num_free) * static_cast<double>(num_free - 1));
}

// Whether a full matrix of all cameras is faster than a sparse one: there are few cameras, or most
// see something together (a desk, a turntable), so that the factor fills up.
bool IsDense(const BundleProblem& problem, const Gauge& gauge) {
  const auto num_free =
      static_cast<size_t>(std::count(gauge.fixed.begin(), gauge.fixed.end(), false));
  if (num_free <= kMaxDenseCameras) return true;
  return num_free <= kMaxConnectedCameras &&
         ConnectedShare(problem, gauge, num_free) >= kMinConnectedShare;
}

// What the reprojections that may be computed are good for.
int MaxIterations(const BundleProblem& problem, const BundleOptions& options) {
  if (options.max_reprojections <= 0.0) return options.max_iterations;
  const double affordable =
      options.max_reprojections / static_cast<double>(problem.observations.size());
  const int bound = static_cast<int>(std::max<double>(affordable, kMinBoundIterations));
  return std::min(bound, options.max_iterations);
}

ceres::Solver::Options SolverOptions(const BundleProblem& problem, const BundleOptions& options,
                                     const Gauge& gauge, GiveUp* give_up) {
  ceres::Solver::Options solver_options;
  solver_options.linear_solver_type =
      IsDense(problem, gauge) ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
  solver_options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  solver_options.dense_linear_algebra_library_type = ceres::EIGEN;
  solver_options.num_threads = 1;
  if (!problem.intrinsics.empty()) solver_options.initial_trust_region_radius = kWideRegion;
  solver_options.max_num_iterations = MaxIterations(problem, options);
  solver_options.function_tolerance = options.function_tolerance;
  solver_options.logging_type = ceres::SILENT;
  solver_options.callbacks = {give_up};
  return solver_options;
}

}  // namespace

BundleReport AdjustBundle(BundleProblem* problem, const BundleOptions& options) {
  BundleReport report;
  GiveUp give_up(options.is_given_up);
  if (give_up.Now()) report.message = "given up";
  if (problem->cameras.size() < 2 || problem->observations.empty()) {
    report.message = "fewer than two cameras, or no observations";
  }
  if (!report.message.empty()) return report;
  CameraBlocks blocks = BlocksOf(*problem);
  const std::vector<Eigen::Vector3d> points_before = problem->points;
  const Gauge gauge = ChooseGauge(*problem);

  const Costs costs = CostsOf(*problem);
  std::optional<ceres::CauchyLoss> loss;
  if (options.loss_sigmas > 0.0) loss.emplace(options.loss_sigmas);
  ceres::Problem solver(ProblemOptions());
  AddObservations(problem, loss ? &*loss : nullptr, costs, &blocks, &solver);
  SetGauge(gauge, &blocks.poses, &solver);
  ceres::Solver::Options solver_options = SolverOptions(*problem, options, gauge, &give_up);
  solver_options.linear_solver_ordering = MakeOrdering(&problem->points, &blocks, solver);
  if (options.settle_points && blocks.poses.size() >= kMinSettlingCameras) {
    SettlePoints(&solver_options);
  }
  const ceres::Solver::Summary summary = SolveQuietly(solver_options, &solver);
  report.iterations = static_cast<int>(summary.iterations.size());
  report.initial_cost = summary.initial_cost;
  report.final_cost = summary.final_cost;
  report.usable = summary.IsSolutionUsable();
  if (!report.usable) {
    report.message = summary.message;
    problem->points = points_before;
    return report;
  }
  TakeBlocks(blocks, gauge, problem);
  return report;
}

}  // namespace rovio_sfm
