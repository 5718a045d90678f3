#pragma once

#include <optional>
#include <string>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// Wheel odometry as a bounding box of the camera's motion (§3.5, §6.2): wide, since wheels slip.
struct OdometryGateOptions {
  bool enabled = false;
  double max_rotation_gap_deg = 15.0;   // between wheels and camera; 0.5 to 180
  double max_direction_gap_deg = 60.0;  // of the translation; 1 to 180
  double min_distance_m = 0.05;         // shorter moves have no direction worth comparing; 0 to 10

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
};

// The camera's pose in odom, metres; nothing where the wheels or the head are unknown.
std::optional<Rigid3> OdomFromCamera(const std::optional<OdometrySample>& odometry,
                                     const std::optional<Rigid3>& base_from_camera);

// True if the pair's relative pose fits what the wheels say of both frames.
bool PassesOdometryGate(const PairMatches& pair, const Rigid3& odom_from_other,
                        const Rigid3& odom_from_camera, const OdometryGateOptions& options);

}  // namespace rovio_sfm
