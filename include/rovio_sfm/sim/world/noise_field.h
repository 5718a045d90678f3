#pragma once

#include <opencv2/core.hpp>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {

struct NoiseFieldOptions {
  double coarsest_px = 400.0;  // size of the largest blobs
  double finest_px = 1.5;      // size of the smallest; a texture has no white noise below it
  double stretch = 1.0;      // blobs are this many times longer along x than along y (wood, metal)
  double octave_gain = 1.0;  // amplitude of an octave against the next coarser; 1 is about 1/f
};

// A seeded random field (CV_32F, mean about 0, standard deviation about 1) whose amplitude spectrum
// falls about as 1/frequency, as that of natural surfaces: a sum of octaves of smooth noise.
cv::Mat MakeNoiseField(const cv::Size& size_px, const NoiseFieldOptions& options, Rng& rng);

}  // namespace rovio_sfm::sim
