#include "rovio_sfm/sessions/pose_graph.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/median.h"
#include "rovio_sfm/util/quiet_ceres.h"

namespace rovio_sfm {
namespace {

constexpr int kNodeSize = 8;  // quaternion x y z w, translation, log scale of node_from_map
constexpr int kErrorSize = 7;
constexpr int kMaxIterations = 50;   // of the last solution
constexpr int kEarlyIterations = 6;  // of those before: the next limit moves the goal anyway
// A switchable edge off by more is left out; 99.9 % of true ones are nearer (7 dimensions).
constexpr double kSwitchSigmas = 5.0;
constexpr double kTightening = 0.25;  // of the square that a switchable edge may be off, each time

using NodeBlock = std::array<double, kNodeSize>;

NodeBlock ToBlock(const Sim3& node_from_map) {
  const Eigen::Quaterniond& q = node_from_map.rotation;
  const Eigen::Vector3d& t = node_from_map.translation;
  return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z(), std::log(node_from_map.scale)};
}

Sim3 FromBlock(const NodeBlock& b) {
  return {
      std::exp(b[7]), Eigen::Quaterniond(b[3], b[0], b[1], b[2]).normalized(), {b[4], b[5], b[6]}};
}

// Rotation vector, translation and log scale, in sigmas, of the way from b over a back to b.
struct EdgeError {
  PoseGraphEdge edge;

  template <typename T>
  bool operator()(const T* node_a, const T* node_b, T* error) const {
    using std::exp;
    using Vector3 = Eigen::Matrix<T, 3, 1>;
    const Eigen::Map<const Eigen::Quaternion<T>> a_rotation(node_a), b_rotation(node_b);
    const Eigen::Map<const Vector3> a_translation(node_a + 4), b_translation(node_b + 4);
    const Eigen::Quaternion<T> a_from_b = a_rotation * b_rotation.conjugate();
    const T a_from_b_scale = exp(node_a[7] - node_b[7]);
    const Vector3 shift = a_translation - a_from_b_scale * (a_from_b * b_translation);

    const Eigen::Quaternion<T> measured = edge.b_from_a.rotation.cast<T>();
    const Eigen::Quaternion<T> turn = measured * a_from_b;
    const T turn_wxyz[4] = {turn.w(), turn.x(), turn.y(), turn.z()};
    ceres::QuaternionToAngleAxis(turn_wxyz, error);
    Eigen::Map<Vector3>{error} /= T(edge.sigma_rotation_rad);
    Eigen::Map<Vector3>{error + 3} =
        (edge.b_from_a.scale * (measured * shift) + edge.b_from_a.translation.cast<T>()) /
        T(edge.sigma_translation);
    error[6] = (std::log(edge.b_from_a.scale) + node_a[7] - node_b[7]) / edge.sigma_log_scale;
    return true;
  }
};

// An edge with a switch s of its own, solved for: the least s^2 x + (1 - s)^2 limit.
class SwitchLoss final : public ceres::LossFunction {
 public:
  explicit SwitchLoss(double limit) : limit_(limit) {}

  void Evaluate(double squared, double rho[3]) const override {
    const double s = limit_ / (limit_ + squared);
    rho[0] = s * squared;
    rho[1] = s * s;
    rho[2] = -2.0 * s * s / (limit_ + squared);
  }

 private:
  double limit_;
};

// One solution with the edges in use; those that are switchable weigh less beyond the limit, a
// limit of 0 takes them as they are.
struct Round {
  std::vector<bool> in_use;
  double limit = 0.0;
  int max_iterations = 0;
};

void AddEdges(const PoseGraph& graph, const Round& round, std::vector<NodeBlock>* blocks,
              ceres::Problem* problem) {
  for (size_t i = 0; i < graph.edges.size(); ++i) {
    if (!round.in_use[i]) continue;
    const PoseGraphEdge& edge = graph.edges[i];
    const bool loses = edge.switchable && round.limit > 0.0;
    problem->AddResidualBlock(
        new ceres::AutoDiffCostFunction<EdgeError, kErrorSize, kNodeSize, kNodeSize>(
            new EdgeError{edge}),
        loses ? new SwitchLoss(round.limit) : nullptr, (*blocks)[edge.a].data(),
        (*blocks)[edge.b].data());
  }
}

void SetManifolds(const PoseGraph& graph, std::vector<NodeBlock>* blocks, ceres::Problem* problem) {
  using NodeManifold =
      ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<4>>;
  const bool any_fixed = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                     [](const PoseGraphNode& node) { return node.fixed; });
  for (size_t i = 0; i < blocks->size(); ++i) {
    double* block = (*blocks)[i].data();
    if (!problem->HasParameterBlock(block)) continue;
    problem->SetManifold(block, new NodeManifold);
    if (graph.nodes[i].fixed || (!any_fixed && i == 0)) problem->SetParameterBlockConstant(block);
  }
}

ceres::Solver::Summary Solve(const Round& round, PoseGraph* graph) {
  std::vector<NodeBlock> blocks;
  for (const PoseGraphNode& node : graph->nodes) blocks.push_back(ToBlock(node.node_from_map));
  ceres::Problem problem;
  AddEdges(*graph, round, &blocks, &problem);
  SetManifolds(*graph, &blocks, &problem);
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  solver.num_threads = 1;
  solver.max_num_iterations = round.max_iterations;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary = SolveQuietly(solver, &problem);
  if (!summary.IsSolutionUsable()) return summary;
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (problem.HasParameterBlock(blocks[i].data()) &&
        !problem.IsParameterBlockConstant(blocks[i].data())) {
      graph->nodes[i].node_from_map = FromBlock(blocks[i]);
    }
  }
  return summary;
}

// 0 without switchable edges.
double MedianSwitchableError(const PoseGraph& graph) {
  std::vector<double> errors;
  for (const PoseGraphEdge& edge : graph.edges) {
    if (edge.switchable) errors.push_back(EdgeErrorSigmas(graph, edge));
  }
  if (errors.empty()) return 0.0;
  return Median(std::move(errors));
}

// The limits of the switchable edges, from one that most of them keep to the last.
std::vector<double> SwitchLimits(double median_error) {
  std::vector<double> limits;
  const double last = kSwitchSigmas * kSwitchSigmas;
  for (double limit = 4.0 * median_error * median_error; limit > last; limit *= kTightening) {
    limits.push_back(limit);
  }
  limits.push_back(last);
  return limits;
}

double CostOf(const PoseGraph& graph, const std::vector<bool>& in_use) {
  double sum = 0.0;
  for (size_t i = 0; i < graph.edges.size(); ++i) {
    if (in_use[i]) sum += std::pow(EdgeErrorSigmas(graph, graph.edges[i]), 2);
  }
  return 0.5 * sum;
}

void CheckGraph(const PoseGraph& graph) {
  for (const PoseGraphEdge& edge : graph.edges) {
    ROVIO_CHECK(edge.a < graph.nodes.size() && edge.b < graph.nodes.size() && edge.a != edge.b);
    ROVIO_CHECK(edge.sigma_rotation_rad > 0.0 && edge.sigma_translation > 0.0 &&
                edge.sigma_log_scale > 0.0 && edge.b_from_a.scale > 0.0);
  }
}

// Solves round after round; false, with the reason, where one fails.
bool SolveRounds(const std::vector<Round>& rounds, PoseGraph* graph, PoseGraphReport* report) {
  for (const Round& round : rounds) {
    const ceres::Solver::Summary summary = Solve(round, graph);
    report->iterations += static_cast<int>(summary.iterations.size());
    if (summary.IsSolutionUsable()) continue;
    report->message = summary.message;
    return false;
  }
  return true;
}

}  // namespace

double EdgeErrorSigmas(const PoseGraph& graph, const PoseGraphEdge& edge) {
  const NodeBlock a = ToBlock(graph.nodes[edge.a].node_from_map);
  const NodeBlock b = ToBlock(graph.nodes[edge.b].node_from_map);
  Eigen::Matrix<double, kErrorSize, 1> error;
  EdgeError{edge}(a.data(), b.data(), error.data());
  return error.norm();
}

PoseGraphReport OptimizePoseGraph(PoseGraph* graph) {
  CheckGraph(*graph);
  PoseGraphReport report;
  if (graph->edges.empty()) {
    report.message = "no edges";
    return report;
  }
  PoseGraph solved = *graph;
  std::vector<bool> in_use(graph->edges.size(), true);
  std::vector<Round> rounds;
  const double median_error = MedianSwitchableError(*graph);
  if (median_error > 0.0) {
    for (const double limit : SwitchLimits(median_error)) {
      rounds.push_back({in_use, limit, kEarlyIterations});
    }
  }
  if (!SolveRounds(rounds, &solved, &report)) return report;
  for (uint32_t i = 0; i < solved.edges.size(); ++i) {
    const PoseGraphEdge& edge = solved.edges[i];
    if (!edge.switchable || EdgeErrorSigmas(solved, edge) <= kSwitchSigmas) continue;
    in_use[i] = false;
    report.switched_off.push_back(i);
  }
  if (!SolveRounds({{in_use, 0.0, kMaxIterations}}, &solved, &report)) return report;
  report.initial_cost = CostOf(*graph, in_use);
  report.final_cost = CostOf(solved, in_use);
  report.usable = true;
  *graph = solved;
  return report;
}

}  // namespace rovio_sfm
