#pragma once

#include <cstddef>

#include "rovio_sfm/sfm/adjust_bundle.h"

namespace rovio_sfm {

// AdjustBundle for problems of any size: beyond max_cameras the cameras are adjusted in windows of
// so many, in order, each overlapping the one before by half, forward and then back; whoever else
// sees a window's points is fixed meanwhile, and so is the first camera. The time grows with the
// number of cameras, not with its third power; what is bent over many windows must be straightened
// before, as by a pose graph. Windows that are not usable change nothing; the report is not usable
// if none was. max_cameras: 2 or more.
BundleReport AdjustByWindow(BundleProblem* problem, const BundleOptions& options,
                            size_t max_cameras);

}  // namespace rovio_sfm
