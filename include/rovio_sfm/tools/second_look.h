#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// How a synthetic second look at a photograph differs from the first: a robot comes back to a place
// with another distance, angle, light and noise.
struct SecondLookOptions {
  double max_roll_deg = 5.0;     // 0 to 45
  double max_zoom = 1.4;         // greatest scale; the least is its inverse; 1 to 4
  double max_shift = 0.2;        // of the image's width and height; 0 to 0.9
  double max_perspective = 0.3;  // change of scale from edge to edge, as a share; 0 to 0.9
  double max_gain = 1.3;         // of brightness; the least is its inverse; 1 to 4
  double noise_sigma = 10.0;     // grey levels; 0 to 50
  int max_pairs = 100;           // images looked at twice; 1 to 100000

  bool IsValid(std::string* error) const;
};

// An 8-bit BGR image of the same size that shows the same surface, by a random homography, gain and
// noise.
cv::Mat TakeSecondLook(const cv::Mat& bgr, const SecondLookOptions& options, Rng* rng);

}  // namespace rovio_sfm
