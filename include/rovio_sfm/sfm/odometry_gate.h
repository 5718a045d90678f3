#pragma once

#include <optional>
#include <string>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Wheel odometry as a bounding box of the camera's motion (§3.5, §6.2): wide, since wheels slip.
struct OdometryGateOptions {
  bool enabled = false;
  double max_rotation_gap_deg = 15.0;
  double max_direction_gap_deg = 60.0;
  double min_distance_m = 0.05;

  void DescribeOptions(OptionTable& table) {
    table.AddFlag("enabled", enabled, "");
    table.AddNumber("max_rotation_gap_deg", max_rotation_gap_deg, 0.5, 180.0, "wheels and camera");
    table.AddNumber("max_direction_gap_deg", max_direction_gap_deg, 1.0, 180.0, "of directions");
    table.AddNumber("min_distance_m", min_distance_m, 0.0, 10.0, "shorter moves have no direction");
  }
};

// The camera's pose in odom, metres; nothing where the wheels or the head are unknown.
std::optional<Rigid3> OdomFromCamera(const std::optional<OdometrySample>& odometry,
                                     const std::optional<Rigid3>& base_from_camera);

// True if the pair's relative pose fits what the wheels say of both frames.
bool PassesOdometryGate(const PairMatches& pair, const Rigid3& odom_from_other,
                        const Rigid3& odom_from_camera, const OdometryGateOptions& options);

}  // namespace rovio_sfm
