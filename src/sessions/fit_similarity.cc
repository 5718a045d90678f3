#include "rovio_sfm/sessions/fit_similarity.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "rovio_sfm/sessions/cross_residual.h"
#include "rovio_sfm/util/quiet_ceres.h"

namespace rovio_sfm {
namespace {

constexpr int kSize = 7;  // rotation vector, translation / radius, log scale, about the centre
constexpr double kMinEigenvalue = 1e-12;  // of the normalised Hessian; rounding leaves about 1e-16

using Step = std::array<double, kSize>;
template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// A small similarity of b about the middle of what is seen, so that its parameters are of one size
// in every gauge.
struct StepFrame {
  Sim3 initial_b_from_a;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 1.0;

  template <typename T>
  Vector3<T> Apply(const T* step, const Eigen::Vector3d& x) const {
    const Vector3<T> from_center = (x - center).cast<T>();
    Vector3<T> turned;
    ceres::AngleAxisRotatePoint(step, from_center.data(), turned.data());
    using std::exp;
    return center.cast<T>() + exp(step[6]) * turned + radius * Shift(step);
  }

  template <typename T>
  Vector3<T> ApplyInverse(const T* step, const Eigen::Vector3d& x) const {
    using std::exp;
    const Vector3<T> back = exp(-step[6]) * ((x - center).cast<T>() - radius * Shift(step));
    const T inverse_turn[3] = {-step[0], -step[1], -step[2]};
    Vector3<T> turned;
    ceres::AngleAxisRotatePoint(inverse_turn, back.data(), turned.data());
    return center.cast<T>() + turned;
  }

  template <typename T>
  static Vector3<T> Shift(const T* step) {
    return {step[3], step[4], step[5]};
  }
};

// A landmark of one session, x_in_b, as the other session's frame should see it.
struct LandmarkCost {
  const StepFrame& frame;
  bool inverse;       // the frame is of session a: it moves, not the landmark
  Rigid3 cam_from_b;  // at the initial similarity
  Eigen::Vector3d x_in_b;
  Eigen::Vector2d x_normalized;
  Eigen::Matrix2d whitening;

  template <typename T>
  bool operator()(const T* step, T* residuals) const {
    const Vector3<T> moved = inverse ? frame.ApplyInverse(step, x_in_b) : frame.Apply(step, x_in_b);
    const Vector3<T> x =
        cam_from_b.rotation.toRotationMatrix().cast<T>() * moved + cam_from_b.translation.cast<T>();
    if (!(x.z() > T(0.0))) return false;  // Ceres shortens the step
    Eigen::Map<Eigen::Matrix<T, 2, 1>> residual(residuals);
    residual = whitening.cast<T>() * (x.hnormalized() - x_normalized.cast<T>());
    return true;
  }
};

struct DepthCost {
  const StepFrame& frame;
  Rigid3 cam_from_b;
  Eigen::Vector3d x_in_b;
  double depth_in_b;  // of session b's own landmark
  double weight;

  template <typename T>
  bool operator()(const T* step, T* residuals) const {
    const Eigen::Vector3d axis = cam_from_b.rotation.toRotationMatrix().row(2);
    const T depth = axis.cast<T>().dot(frame.Apply(step, x_in_b)) + cam_from_b.translation.z();
    if (!(depth > T(0.0))) return false;
    using std::log;
    residuals[0] = weight * log(depth / depth_in_b);
    return true;
  }
};

struct ScaleCost {
  double log_ratio;  // of the initial scale to the prior's
  double weight;

  template <typename T>
  bool operator()(const T* step, T* residuals) const {
    residuals[0] = weight * (log_ratio + step[6]);
    return true;
  }
};

StepFrame MakeFrame(const std::vector<CrossMatch>& matches, const std::vector<uint32_t>& chosen,
                    const Sim3& b_from_a) {
  StepFrame frame{b_from_a, Eigen::Vector3d::Zero(), 0.0};
  std::vector<Eigen::Vector3d> points, centers;
  for (const uint32_t i : chosen) {
    const CrossMatch& match = matches[i];
    points.push_back(match.b.landmark ? match.b.landmark->position
                                      : b_from_a * match.a.landmark->position);
    centers.push_back(OriginInA(match.b.cam_from_session));
    frame.center += points.back();
  }
  frame.center /= static_cast<double>(points.size());
  for (size_t i = 0; i < points.size(); ++i) frame.radius += (points[i] - centers[i]).norm();
  frame.radius /= static_cast<double>(points.size());
  return frame;
}

template <int kResiduals, typename Cost>
void AddCost(Cost cost, double loss_sigmas, Step* step, ceres::Problem* problem) {
  problem->AddResidualBlock(
      new ceres::AutoDiffCostFunction<Cost, kResiduals, kSize>(new Cost(std::move(cost))),
      loss_sigmas > 0.0 ? new ceres::CauchyLoss(loss_sigmas) : nullptr, step->data());
}

// The costs of one match; frame is borrowed until the problem is gone.
void AddMatch(const CrossMatch& match, const CrossWeights& weights, const StepFrame& frame,
              double loss_sigmas, Step* step, ceres::Problem* problem) {
  const Sim3& b_from_a = frame.initial_b_from_a;
  const Rigid3& cam_from_b = match.b.cam_from_session;
  if (weights.a_in_b) {
    AddCost<2>(LandmarkCost{frame, false, cam_from_b, b_from_a * match.a.landmark->position,
                            match.b.x_normalized, *weights.a_in_b},
               loss_sigmas, step, problem);
  }
  if (weights.b_in_a) {
    AddCost<2>(LandmarkCost{frame, true, TransformCamera(b_from_a, match.a.cam_from_session),
                            match.b.landmark->position, match.a.x_normalized, *weights.b_in_a},
               loss_sigmas, step, problem);
  }
  if (weights.log_depth) {
    AddCost<1>(DepthCost{frame, cam_from_b, b_from_a * match.a.landmark->position,
                         (cam_from_b * match.b.landmark->position).z(), *weights.log_depth},
               loss_sigmas, step, problem);
  }
}

// False where a chosen match has no residual.
bool AddMatches(const std::vector<CrossMatch>& matches, const std::vector<uint32_t>& chosen,
                const StepFrame& frame, const FitSimilarityOptions& options, double loss_sigmas,
                Step* step, ceres::Problem* problem) {
  for (const uint32_t i : chosen) {
    const double floor = options.sigma_log_distance_floor;
    if (!ResidualOf(matches[i], frame.initial_b_from_a, floor)) return false;
    const auto weights = WeighMatch(matches[i], frame.initial_b_from_a, floor);
    AddMatch(matches[i], *weights, frame, loss_sigmas, step, problem);
  }
  if (options.scale_prior) {
    const double log_ratio = std::log(frame.initial_b_from_a.scale / options.scale_prior->scale);
    AddCost<1>(ScaleCost{log_ratio, 1.0 / options.scale_prior->sigma_log}, 0.0, step, problem);
  }
  return frame.radius > 0.0;
}

// The similarity of b that a step is.
Sim3 StepSim3(const StepFrame& frame, const Step& step) {
  const Eigen::Vector3d turn(step[0], step[1], step[2]);
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
  const double scale = std::exp(step[6]);
  return {scale, rotation,
          frame.center - scale * (rotation * frame.center) +
              frame.radius * StepFrame::Shift(step.data())};
}

using Matrix7d = Eigen::Matrix<double, kSize, kSize>;

// Nothing where some step changes no residual.
std::optional<Matrix7d> Covariance(const Matrix7d& hessian) {
  const Eigen::Matrix<double, kSize, 1> scale = hessian.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  const Matrix7d normalised = scale.asDiagonal() * hessian * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix7d> solver(normalised);
  if (!(solver.eigenvalues()[0] > kMinEigenvalue)) return std::nullopt;
  const Matrix7d inverse = solver.eigenvectors() *
                           solver.eigenvalues().cwiseInverse().asDiagonal() *
                           solver.eigenvectors().transpose();
  return Matrix7d(scale.asDiagonal() * inverse * scale.asDiagonal());
}

Matrix7d HessianOf(const ceres::CRSMatrix& jacobian) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, kSize, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> dense(jacobian.values.data(), jacobian.num_rows, kSize);
  return dense.transpose() * dense;
}

}  // namespace

std::optional<Sim3> FitSimilarity(const std::vector<CrossMatch>& matches,
                                  const std::vector<uint32_t>& chosen, const Sim3& initial_b_from_a,
                                  const FitSimilarityOptions& options) {
  if (chosen.empty()) return std::nullopt;
  const StepFrame frame = MakeFrame(matches, chosen, initial_b_from_a);
  Step step{};
  ceres::Problem problem;
  if (!AddMatches(matches, chosen, frame, options, options.loss_sigmas, &step, &problem)) {
    return std::nullopt;
  }
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.num_threads = 1;
  solver.max_num_iterations = options.max_iterations;
  solver.logging_type = ceres::SILENT;
  const ceres::Solver::Summary summary = SolveQuietly(solver, &problem);
  if (!summary.IsSolutionUsable()) return std::nullopt;
  return StepSim3(frame, step) * initial_b_from_a;
}

std::optional<SimilarityUncertainty> MeasureUncertainty(const std::vector<CrossMatch>& matches,
                                                        const std::vector<uint32_t>& chosen,
                                                        const Sim3& b_from_a,
                                                        const FitSimilarityOptions& options) {
  if (chosen.empty()) return std::nullopt;
  const StepFrame frame = MakeFrame(matches, chosen, b_from_a);
  Step step{};
  ceres::Problem problem;
  if (!AddMatches(matches, chosen, frame, options, 0.0, &step, &problem)) return std::nullopt;
  std::vector<double> residuals;
  ceres::CRSMatrix jacobian;
  if (!problem.Evaluate({}, nullptr, &residuals, nullptr, &jacobian)) return std::nullopt;
  const double count = static_cast<double>(residuals.size());
  const auto covariance = Covariance(HessianOf(jacobian));
  if (!covariance || count <= kSize) return std::nullopt;
  double sum = 0.0;
  for (const double residual : residuals) sum += residual * residual;
  const double inflation = std::max(1.0, std::sqrt(sum / (count - kSize)));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> turn(covariance->topLeftCorner<3, 3>(),
                                                            Eigen::EigenvaluesOnly);
  return SimilarityUncertainty{inflation * std::sqrt((*covariance)(6, 6)),
                               inflation * std::sqrt(turn.eigenvalues()[2]),
                               std::sqrt(sum / count)};
}

}  // namespace rovio_sfm
