#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/io/trajectory_file.h"

namespace rovio_sfm {

// What was estimated of one drive, and the truth. Poses are map_from_camera and world_from_camera.
struct DriveEvaluation {
  std::vector<StampedPose> estimate;
  std::vector<StampedPose> ground_truth;  // metres
};

inline constexpr int64_t kMaxTruthGapNs = 50'000'000;  // five samples of a motion capture

// Errors after ONE similarity over all posed images of all drives. Lengths in metres.
struct EvaluationReport {
  size_t num_poses = 0;     // estimated
  size_t num_compared = 0;  // of them with ground truth; the others lie in gaps
  Sim3 world_from_map;
  double ate_rmse_m = 0.0, ate_p95_m = 0.0, ate_max_m = 0.0;  // camera centres
  double rotation_rmse_deg = 0.0;
  // About the main direction of the true path, which centres alone leave free on a straight one:
  // the roll that all orientations together ask for, and what is left of the rotations after it.
  double roll_deg = 0.0, rotation_rmse_after_roll_deg = 0.0;
  size_t num_rpe_pairs = 0;
  std::optional<double> rpe_rmse_m, rpe_rotation_rmse_deg;  // over a second; none without pairs
  double path_length_m = 0.0;  // of the true centres of the compared images, all drives together
  double scale_error = 0.0;    // |s - 1|: meaningful for metric maps only
};

// Compares trajectories with the truth by the definitions of docs/benchmarks.md. Wider gaps
// of the truth are left out. Nothing where fewer than three poses have ground truth or their
// centres lie on one line.
std::optional<EvaluationReport> EvaluateTrajectories(const std::vector<DriveEvaluation>& drives,
                                                     int64_t max_gap_ns = kMaxTruthGapNs);

}  // namespace rovio_sfm
