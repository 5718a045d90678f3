#pragma once

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// How well a feature is placed: sigma_px of a small one; of one with a diameter of more than
// size_px it grows with (size / size_px) to the exponent.
struct FeatureNoise {
  double sigma_px = 1.0;
  double size_px = 6.0;
  double exponent = 0.5;
};

// One sigma of the feature's position on the plane z = 1.
double SigmaOf(const Keypoint& keypoint, double focal_px, const FeatureNoise& noise);

}  // namespace rovio_sfm
