#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// A registered frame: how the base is turned by vision and by the wheels.
struct TurnSample {
  int64_t stamp_ns = 0;                                               // of the image
  Eigen::Quaterniond map_from_base = Eigen::Quaterniond::Identity();  // z of the base is up
  double odom_yaw_rad = 0.0;                                          // at the same stamp
};

struct OdometryDelayOptions {
  double max_delay_s = 0.4;      // longer ones are not looked for; 0.05 to 5
  double max_gap_s = 1.0;        // a turn rate is measured over no longer time; 0.3 to 10
  double min_turn_rad = 1.0;     // all turns together; 0.1 to 100
  double min_correlation = 0.8;  // of the turn rates; 0.1 to 1
  double max_sigma_s = 0.05;     // a less certain delay is none; 0.001 to 1
  int min_rates = 20;            // 5 to 100000
  bool IsValid(std::string* error) const;
};

// The delay at which the turn rates of vision and wheels agree best: their correlation, its peak
// refined by a parabola; sigma from the rates' disagreement there. Samples by rising stamp. Nothing
// without enough turning, or where the rates do not tell.
std::optional<OdometryDelay> EstimateOdometryDelay(const std::vector<TurnSample>& samples,
                                                   const OdometryDelayOptions& options);

}  // namespace rovio_sfm
