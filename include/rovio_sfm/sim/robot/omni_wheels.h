#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {

// The simulated chassis: three omni wheels at 0.145 m from the middle. Front wheels roll 30° off
// forward, the rear wheel rolls sideways. Written for the simulator alone, from the geometry.
struct OmniGeometry {
  double ticks_per_m = 465.0;  // of rim travel
  double center_distance_m = 0.145;
  double wheel_angle_rad = 0.52359877559829887;  // 30 deg
};

// A small motion in the base's own frame: forward (m), to the left (m), counter-clockwise (rad).
struct BodyMotion {
  double forward_m = 0.0, left_m = 0.0, turn_rad = 0.0;
};

enum Wheel { kLeftWheel = 0, kRightWheel = 1, kRearWheel = 2 };

// Rim travel of each wheel without slip, in metres; positive: the left and right wheels drive
// forward, the rear wheel drives the tail to the left.
std::array<double, 3> RimTravel(const BodyMotion& motion, const OmniGeometry& geometry);

// How the floor cheats a robot; drawn once per drive.
struct SlipOptions {
  double forward_gain_spread = 0.05;  // ground / rim is within 1 ± this
  double min_side_loss = 0.15, max_side_loss = 0.30;
  double heading_walk_rad_per_sqrt_m = 0.02;  // of a random walk over the way driven
  double lost_tick_share = 0.01;              // 0 … 0.5

  bool IsValid(std::string* error) const;
};

struct Slip {
  double forward_gain = 1.0;  // metres of ground per metre that the wheels turned for
  double side_gain = 1.0;
  double turn_gain = 1.0;
};

Slip DrawSlip(const SlipOptions& options, Rng& rng);

// Counts a drive's ticks: fractions are carried over, some ticks get lost.
class TickCounter {
 public:
  TickCounter(const OmniGeometry& geometry, double lost_tick_share, Rng rng);

  // Adds rim travel; returns the signed ticks that were counted for each wheel.
  std::array<int, 3> Add(const std::array<double, 3>& rim_m);

 private:
  OmniGeometry geometry_;
  double lost_tick_share_;
  Rng rng_;
  std::array<double, 3> fraction_{};
};

}  // namespace rovio_sfm::sim
