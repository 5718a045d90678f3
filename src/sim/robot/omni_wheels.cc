#include "rovio_sfm/sim/robot/omni_wheels.h"

#include <cmath>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {

bool SlipOptions::IsValid(std::string* error) const {
  OptionChecker check("slip", error);
  check.Range("forward_gain_spread", forward_gain_spread, 0.0, 0.5);
  check.Range("min_side_loss", min_side_loss, 0.0, 0.9);
  check.Range("max_side_loss", max_side_loss, min_side_loss, 0.9);
  check.Range("heading_walk_rad_per_sqrt_m", heading_walk_rad_per_sqrt_m, 0.0, 1.0);
  check.Range("lost_tick_share", lost_tick_share, 0.0, 0.5);
  return check.Passed();
}

// The wheels stand at +60, -60 and 180 deg around the middle and roll along the circle; a rim
// travels as its hub does along that way.
std::array<double, 3> RimTravel(const BodyMotion& motion, const OmniGeometry& geometry) {
  const double c = std::cos(geometry.wheel_angle_rad), s = std::sin(geometry.wheel_angle_rad);
  const double turn_m = geometry.center_distance_m * motion.turn_rad;
  return {c * motion.forward_m - s * motion.left_m - turn_m,
          c * motion.forward_m + s * motion.left_m + turn_m, motion.left_m - turn_m};
}

Slip DrawSlip(const SlipOptions& options, Rng& rng) {
  const double spread = options.forward_gain_spread;
  Slip slip;
  slip.forward_gain = 1.0 + rng.Uniform(-spread, spread);
  slip.side_gain = 1.0 - rng.Uniform(options.min_side_loss, options.max_side_loss);
  slip.turn_gain = 1.0 + rng.Uniform(-spread, spread);
  return slip;
}

TickCounter::TickCounter(const OmniGeometry& geometry, double lost_tick_share, Rng rng)
    : geometry_(geometry), lost_tick_share_(lost_tick_share), rng_(rng) {}

std::array<int, 3> TickCounter::Add(const std::array<double, 3>& rim_m) {
  std::array<int, 3> counted{};
  for (size_t wheel = 0; wheel < 3; ++wheel) {
    fraction_[wheel] += rim_m[wheel] * geometry_.ticks_per_m;
    const int whole = static_cast<int>(fraction_[wheel]);
    fraction_[wheel] -= whole;
    const int sign = whole < 0 ? -1 : 1;
    for (int i = 0; i < std::abs(whole); ++i) {
      if (rng_.Uniform() >= lost_tick_share_) counted[wheel] += sign;
    }
  }
  return counted;
}

}  // namespace rovio_sfm::sim
