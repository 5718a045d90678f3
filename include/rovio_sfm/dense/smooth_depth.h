#pragma once

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

struct SmoothingOptions {
  int radius_px = 15, stride_px = 3;  // of the window, at half size, and between the pixels taken
  double reach_px = 1.0;              // a depth's error, beyond which it is of something else
  int min_pixels = 12;                // of the same surface
};

// Every depth on the plane that its surroundings lie on: inverse depth is linear in the pixel on a
// plane, fitted to the pixels around that agree within their sigma, the better measured weighing
// more (Tukey's weights). What lies on no surface with enough pixels, as do the wrong depths
// between a near thing and what is behind it, is 0.
MeasuredDepth SmoothDepth(const MeasuredDepth& measured, const SmoothingOptions& options);

}  // namespace rovio_sfm
