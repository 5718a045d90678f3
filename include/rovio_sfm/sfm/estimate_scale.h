#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/sfm/odometry_gains.h"

namespace rovio_sfm {

// A registered frame with what the wheels say.
struct ScaleSample {
  Rigid3 cam_from_map;      // map units
  Rigid3 odom_from_camera;  // metres
  double yaw_rad = 0.0;     // heading of the base in odom
};

struct EstimateScaleOptions {
  double min_distance_m = 0.3;
  double max_rotation_gap_rad = 0.035;
  OdometryGains gains;  // averaging never goes below them
};

// Metres per map unit from wheel odometry (design 5.2.7): the weighted median of log ratios of
// odometric to visual displacement over windows of at least min_distance_m whose rotations agree;
// windows along the base's x axis weigh most, sideways ones least. sigma_log joins the scatter of
// the mean (MAD / sqrt n, n windows end to end) with the odometry's own gain uncertainty for the
// mix of directions. Nothing for fewer than 3 windows.
std::optional<MapScale> EstimateScale(const std::vector<ScaleSample>& samples,
                                      const EstimateScaleOptions& options);

}  // namespace rovio_sfm
