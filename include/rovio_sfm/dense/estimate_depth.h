#pragma once

#include <vector>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

struct SweepOptions {
  size_t max_neighbors = 8;      // the first of a view's
  int window_px = 5;             // of the correlation, odd, at most 13, at half size
  int max_planes = 80;           // fewer where the neighbours' parallax needs fewer
  double min_correlation = 0.4;  // mean of the two best neighbours
  double min_contrast = 3.0;     // grey levels, standard deviation in the window
};

// The depth map of a view by plane sweep (design 5.5): fronto-parallel planes, evenly spaced in
// inverse depth over its range, three quarters of a pixel of the widest neighbour apart (more where
// that took too many); correlation (NCC) with every neighbour, of which the two best count, so that
// others may be hidden. Depths between planes by a parabola. Many are wrong: what other views find
// tells which. Needs at least two neighbours, else nothing is known.
DepthMap EstimateDepth(const DepthView& view, const std::vector<const DepthView*>& neighbors,
                       const SweepOptions& options);

}  // namespace rovio_sfm
