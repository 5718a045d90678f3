#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// A registered frame: how the base is turned by vision and by the wheels.
struct TurnSample {
  int64_t stamp_ns = 0;                                               // of the image
  Eigen::Quaterniond map_from_base = Eigen::Quaterniond::Identity();  // z of the base is up
  double odom_yaw_rad = 0.0;                                          // at the same stamp
};

// The delay at which the turn rates of vision and wheels agree best: their correlation, its peak
// refined by a parabola; sigma from the rates' disagreement there. Samples by rising stamp. Nothing
// without enough turning, or where the rates do not tell.
std::optional<OdometryDelay> EstimateOdometryDelay(const std::vector<TurnSample>& samples);

}  // namespace rovio_sfm
