#pragma once

#include <vector>

#include "rovio_sfm/dense/depth_view.h"

namespace rovio_sfm {

struct AgreementOptions {
  int min_views = 2;             // others that must have found the same point
  double max_gap = 0.05;         // relative, of depths that are the same
  double max_shift_px = 1.0;     // at half size, of the pixel carried there and back
  double min_angle_rad = 0.018;  // 1 deg, under which the view and one of them see the point
};

// The depths of a view that enough of the other views have found too: the point projected into the
// other view, its depth there compared, and that point carried back. Each becomes the mean of what
// they say, the nearer views weighing more; its sigma comes from the angles under which they see
// it. What is not confirmed, or only by views from nearly the same direction, is 0.
MeasuredDepth KeepAgreed(const DepthView& view, const DepthMap& depth,
                         const std::vector<const DepthView*>& others,
                         const std::vector<const DepthMap*>& their_depths,
                         const AgreementOptions& options);

}  // namespace rovio_sfm
