#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/rovio/drive_command.h"

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
  double yaw_tolerance_rad = 0.035;
  double turn_first_rad = 0.15;  // off by more: turn before moving
  double max_speed_m_per_s = 0.18;
  double min_speed_m_per_s = 0.03;  // the robot stalls below
  double max_turn_rad_per_s = 0.8;
  double min_turn_rad_per_s = 0.2;
  double approach_s = 0.5;  // slows down over the way of so long

  bool IsValid(std::string* error) const;
};

// The velocity that brings the robot from where it is towards the stop: first a coarse turn, then a
// move in any direction, then a fine turn. Nothing when it is there.
std::optional<BaseVelocity> SteerTo(const PlanarPose& target, const PlanarPose& present,
                                    const SteerOptions& options);

}  // namespace rovio_sfm
