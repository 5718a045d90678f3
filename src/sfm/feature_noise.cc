#include "rovio_sfm/sfm/feature_noise.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {

double SigmaOf(const Keypoint& keypoint, double focal_px, const FeatureNoise& noise) {
  const double relative_size = std::max(1.0, keypoint.size_px / noise.size_px);
  return noise.sigma_px * std::pow(relative_size, noise.exponent) / focal_px;
}

}  // namespace rovio_sfm
