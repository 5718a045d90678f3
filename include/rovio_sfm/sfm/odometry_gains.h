#pragma once

#include <vector>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// One sigma, relative, of how much longer a way is than the wheels say, along and across the base.
struct OdometryGains {
  double forward_sigma = 0.05;
  double sideways_sigma = 0.2;
};

// What the covariance that a robot's odometry brings tells of its gains. A constant gain makes the
// variance grow with the square of the way, noise with the way itself: both are fitted to the
// variance along the line from the first sample, at every sample (samples of one drive, in order).
// The forward gain is never below that of `least`, which also stands in for a gain that the
// covariance does not tell: none known, no way in that direction, or no growth of its kind.
OdometryGains LearnOdometryGains(const std::vector<OdometrySample>& samples,
                                 const OdometryGains& least);

}  // namespace rovio_sfm
