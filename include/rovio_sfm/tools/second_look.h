#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// How a synthetic second look at a photograph differs from the first: a robot comes back to a place
// with another distance, angle, light and noise.
struct SecondLookOptions {
  double max_roll_deg = 5.0;
  double max_zoom = 1.4;
  double max_shift = 0.2;
  double max_perspective = 0.3;
  double max_gain = 1.3;
  double noise_sigma = 10.0;
  int max_pairs = 100;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_roll_deg", max_roll_deg, 0.0, 45.0, "");
    table.AddNumber("max_zoom", max_zoom, 1.0, 4.0, "the least is its inverse");
    table.AddNumber("max_shift", max_shift, 0.0, 0.9, "of the image's width and height");
    table.AddNumber("max_perspective", max_perspective, 0.0, 0.9, "of scale, from edge to edge");
    table.AddNumber("max_gain", max_gain, 1.0, 4.0, "of brightness; the least is its inverse");
    table.AddNumber("noise_sigma", noise_sigma, 0.0, 50.0, "grey levels");
    table.AddNumber("max_pairs", max_pairs, 1, 100000, "images looked at twice");
  }
};

// An 8-bit BGR image of the same size that shows the same surface, by a random homography, gain and
// noise.
cv::Mat TakeSecondLook(const cv::Mat& bgr, const SecondLookOptions& options, Rng* rng);

}  // namespace rovio_sfm
