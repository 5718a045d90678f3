#pragma once

#include <vector>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

struct CertaintyOptions {
  double max_worse = 1.1;  // a sigma, to the best of those who see the point
  double reach_px = 1.5;   // how far apart, in errors of a pixel, depths of the same may lie
};

// The pixels of a view (CV_8U, 0 or 255) whose points none of the others has measured better: what
// is seen from afar and from near is told by who is near.
cv::Mat FindMostCertain(const DepthView& view, const MeasuredDepth& measured,
                        const std::vector<const DepthView*>& others,
                        const std::vector<const MeasuredDepth*>& theirs,
                        const CertaintyOptions& options);

}  // namespace rovio_sfm
