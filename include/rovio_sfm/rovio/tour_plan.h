#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/rovio/drive_command.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// A pose on the floor: metres, radians; yaw to the left and not wrapped: it tells the turns.
struct PlanarPose {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

// origin_from_pose: the pose as seen from the origin.
PlanarPose RelativeTo(const PlanarPose& origin, const PlanarPose& pose);

// Where a tour goes next: straight, or around a centre with the heading turning along.
struct TourWayPoint {
  PlanarPose pose;
  int num_pictures = 1;  // on the way here, the last one at the pose itself
  std::optional<Eigen::Vector2d> arc_center_m;
};

// One pose per picture, relative to the first way-point: where the robot stands when it starts is
// the origin. Needs at least one way-point.
std::vector<PlanarPose> PlanStops(const std::vector<TourWayPoint>& way_points);

struct SteerOptions {
  double position_tolerance_m = 0.02;
  double yaw_tolerance_rad = 2.0 * M_PI / 180.0;
  double turn_first_rad = 8.5 * M_PI / 180.0;
  double max_speed_m_per_s = 0.18;
  double min_speed_m_per_s = 0.03;
  double max_turn_rad_per_s = 0.8;
  double min_turn_rad_per_s = 0.2;
  double approach_s = 0.5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("position_tolerance_m", position_tolerance_m, 0.005, 1.0, "at a stop");
    table.AddDegrees("yaw_tolerance_deg", yaw_tolerance_rad, 0.3, 90.0, "at a stop");
    table.AddDegrees("turn_first_deg", turn_first_rad, 0.3, 180.0, "off by more: turn first");
    table.AddRule("turn_first_deg", turn_first_rad >= yaw_tolerance_rad,
                  "at least yaw_tolerance_deg");
    table.AddNumber("max_speed_m_per_s", max_speed_m_per_s, 0.001, 1.0, "");
    table.AddNumber("min_speed_m_per_s", min_speed_m_per_s, 0.001, 1.0, "the robot stalls below");
    table.AddRule("min_speed_m_per_s", min_speed_m_per_s <= max_speed_m_per_s,
                  "at most max_speed_m_per_s");
    table.AddNumber("max_turn_rad_per_s", max_turn_rad_per_s, 0.001, 10.0, "");
    table.AddNumber("min_turn_rad_per_s", min_turn_rad_per_s, 0.001, 10.0, "");
    table.AddRule("min_turn_rad_per_s", min_turn_rad_per_s <= max_turn_rad_per_s,
                  "at most max_turn_rad_per_s");
    table.AddNumber("approach_s", approach_s, 0.01, 60.0, "slows down over the way of so long");
  }
};

// The velocity that brings the robot from where it is towards the stop: first a coarse turn, then a
// move in any direction, then a fine turn. Nothing when it is there.
std::optional<BaseVelocity> SteerTo(const PlanarPose& target, const PlanarPose& present,
                                    const SteerOptions& options);

}  // namespace rovio_sfm
