#include "rovio_sfm/report/evaluation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kRpeStepNs = 1'000'000'000;  // the relative error is that of a second

// One posed image with its true pose.
struct Compared {
  size_t drive = 0;
  int64_t stamp_ns = 0;
  Rigid3 map_from_cam;
  Rigid3 world_from_cam;
};

std::vector<Compared> Compare(const std::vector<DriveEvaluation>& drives, int64_t max_gap_ns) {
  std::vector<Compared> compared;
  for (size_t i = 0; i < drives.size(); ++i) {
    for (const StampedPose& pose : drives[i].estimate) {
      const auto truth = InterpolatePose(drives[i].ground_truth, pose.stamp_ns, max_gap_ns);
      if (truth) compared.push_back({i, pose.stamp_ns, pose.reference_from_body, *truth});
    }
  }
  return compared;
}

std::optional<Sim3> Align(const std::vector<Compared>& compared) {
  std::vector<Eigen::Vector3d> in_map, in_world;
  for (const Compared& c : compared) {
    in_map.push_back(c.map_from_cam.translation);
    in_world.push_back(c.world_from_cam.translation);
  }
  return AlignPoints(in_map, in_world);
}

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// The smallest value that at least this share of the values does not exceed.
double NearestRank(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<size_t>(std::max(rank, 1.0)) - 1];
}

void AddAbsoluteErrors(const std::vector<Compared>& compared, EvaluationReport* report) {
  std::vector<double> distances_m, angles_deg;
  for (const Compared& c : compared) {
    const Eigen::Vector3d center = report->world_from_map * c.map_from_cam.translation;
    distances_m.push_back((center - c.world_from_cam.translation).norm());
    const Eigen::Quaterniond rotation = report->world_from_map.rotation * c.map_from_cam.rotation;
    angles_deg.push_back(Degrees(RotationAngle(rotation.conjugate() * c.world_from_cam.rotation)));
  }
  report->ate_rmse_m = RootMeanSquare(distances_m);
  report->ate_p95_m = NearestRank(distances_m, 0.95);
  report->ate_max_m = NearestRank(distances_m, 1.0);
  report->rotation_rmse_deg = RootMeanSquare(angles_deg);
}

// The direction along which the true centres spread most.
Eigen::Vector3d MainDirection(const std::vector<Compared>& compared) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Compared& c : compared) mean += c.world_from_cam.translation;
  mean /= static_cast<double>(compared.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Compared& c : compared) {
    const Eigen::Vector3d off = c.world_from_cam.translation - mean;
    spread += off * off.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
}

// The least-squares angle about an axis between aligned and true orientations: what is left of each
// turns about it by atan2(axis · vector part, scalar part) of its quaternion, twice.
void AddRoll(const std::vector<Compared>& compared, EvaluationReport* report) {
  const Eigen::Vector3d axis = MainDirection(compared);
  std::vector<Eigen::Quaterniond> left;  // true from aligned, in the world
  double along = 0.0, scalar = 0.0;
  for (const Compared& c : compared) {
    Eigen::Quaterniond turn =
        c.world_from_cam.rotation *
        (report->world_from_map.rotation * c.map_from_cam.rotation).conjugate();
    if (turn.w() < 0.0) turn.coeffs() *= -1.0;
    along += axis.dot(turn.vec());
    scalar += turn.w();
    left.push_back(turn);
  }
  const double roll = 2.0 * std::atan2(along, scalar);
  const Eigen::Quaterniond back(Eigen::AngleAxisd(-roll, axis));
  std::vector<double> angles_deg;
  for (const Eigen::Quaterniond& turn : left) {
    angles_deg.push_back(Degrees(RotationAngle(turn * back)));
  }
  report->roll_deg = Degrees(std::abs(roll));
  report->rotation_rmse_after_roll_deg = RootMeanSquare(angles_deg);
}

double PathLength(const std::vector<Compared>& compared) {
  double length_m = 0.0;
  for (size_t i = 1; i < compared.size(); ++i) {
    if (compared[i].drive != compared[i - 1].drive) continue;
    length_m +=
        (compared[i].world_from_cam.translation - compared[i - 1].world_from_cam.translation)
            .norm();
  }
  return length_m;
}

// The first image at least one step, at most one and a half, after image i in the same drive.
std::optional<size_t> OneStepLater(const std::vector<Compared>& compared, size_t i) {
  for (size_t j = i + 1; j < compared.size() && compared[j].drive == compared[i].drive; ++j) {
    const int64_t passed_ns = compared[j].stamp_ns - compared[i].stamp_ns;
    if (passed_ns > kRpeStepNs + kRpeStepNs / 2) return std::nullopt;
    if (passed_ns >= kRpeStepNs) return j;
  }
  return std::nullopt;
}

// The relative motion of the estimate, in metres, as the first camera sees it, against the truth's.
void AddRelativeErrors(const std::vector<Compared>& compared, EvaluationReport* report) {
  std::vector<double> distances_m, angles_deg;
  for (size_t i = 0; i < compared.size(); ++i) {
    const std::optional<size_t> j = OneStepLater(compared, i);
    if (!j) continue;
    Rigid3 moved = Inverse(compared[i].map_from_cam) * compared[*j].map_from_cam;
    moved.translation *= report->world_from_map.scale;
    const Rigid3 truth = Inverse(compared[i].world_from_cam) * compared[*j].world_from_cam;
    const Rigid3 error = Inverse(truth) * moved;
    distances_m.push_back(error.translation.norm());
    angles_deg.push_back(Degrees(RotationAngle(error.rotation)));
  }
  report->num_rpe_pairs = distances_m.size();
  if (distances_m.empty()) return;
  report->rpe_rmse_m = RootMeanSquare(distances_m);
  report->rpe_rotation_rmse_deg = RootMeanSquare(angles_deg);
}

}  // namespace

std::optional<EvaluationReport> EvaluateTrajectories(const std::vector<DriveEvaluation>& drives,
                                                     int64_t max_gap_ns) {
  const std::vector<Compared> compared = Compare(drives, max_gap_ns);
  const std::optional<Sim3> world_from_map = Align(compared);
  if (!world_from_map) return std::nullopt;
  EvaluationReport report;
  for (const DriveEvaluation& drive : drives) report.num_poses += drive.estimate.size();
  report.num_compared = compared.size();
  report.world_from_map = *world_from_map;
  report.scale_error = std::abs(world_from_map->scale - 1.0);
  report.path_length_m = PathLength(compared);
  AddAbsoluteErrors(compared, &report);
  AddRoll(compared, &report);
  AddRelativeErrors(compared, &report);
  return report;
}

}  // namespace rovio_sfm
