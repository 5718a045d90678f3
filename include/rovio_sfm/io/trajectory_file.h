#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/io/write_file.h"

namespace rovio_sfm {

// Where a camera (or head) was: reference_from_body at a stamp. In a trajectory file reference is
// the map or the world of the ground truth, body the camera (z forward).
struct StampedPose {
  int64_t stamp_ns = 0;
  Rigid3 reference_from_body;
};

// Reads a TUM trajectory (timestamp tx ty tz qx qy qz qw). Throws std::runtime_error naming file,
// line and field; stamps must rise, quaternions have a length within 1 % of one.
std::vector<StampedPose> ReadTrajectory(const std::filesystem::path& path);

// The text of a TUM trajectory; nine decimals for positions and quaternions.
std::string TrajectoryText(const std::vector<StampedPose>& trajectory);

// The pose at a stamp, linear and slerp between its two neighbours if they are at most max_gap_ns
// apart; an entry with exactly this stamp always counts. Nothing otherwise. The trajectory rises.
std::optional<Rigid3> InterpolatePose(const std::vector<StampedPose>& trajectory, int64_t stamp_ns,
                                      int64_t max_gap_ns);

}  // namespace rovio_sfm
