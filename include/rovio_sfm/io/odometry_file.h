#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

struct StampedOdometry {
  int64_t stamp_ns = 0;
  OdometrySample sample;
};

// Reads odometry.txt (timestamp x y theta, 3x3 covariance by rows or none; odom_from_base, m and
// rad). Throws std::runtime_error naming file, line and field; stamps must rise.
std::vector<StampedOdometry> ReadOdometry(const std::filesystem::path& path);

// The sample at a stamp, linear between neighbours at most max_gap_ns apart (the shorter way round
// for the angle); an exact stamp always counts. Nothing otherwise. The covariance is known where
// both neighbours' are.
std::optional<OdometrySample> InterpolateOdometry(const std::vector<StampedOdometry>& odometry,
                                                  int64_t stamp_ns, int64_t max_gap_ns);

}  // namespace rovio_sfm
