#pragma once

#include <cstddef>

#include "rovio_sfm/report/level_map.h"

namespace rovio_sfm {

// The figures of a map by the definitions of docs/benchmarks.md.
struct MapStatistics {
  size_t registered = 0;                  // images with a pose of their own
  size_t registered_keyframes = 0;        // of them keyframes
  size_t landmarks = 0;                   // >= 3 views, >= 1.5 degrees of parallax, <= 4 px
  size_t landmarks_two_views = 0;         // the same with two views
  size_t landmarks_over_three_views = 0;  // the same with four and more
  size_t projections = 0;                 // views of all of the above
  double mean_error_px = 0.0;             // mean reprojection error over those projections
  double rms_counted_px = 0.0;            // Eq. 5.2 over those projections, times the focal length
  double rms_n = 0.0;   // Eq. 5.4: over landmarks with more than three views, none left out
  double rms_px = 0.0;  // Eq. 5.2 over the same, times the focal length
};

MapStatistics ComputeMapStatistics(const LevelMap& map);

}  // namespace rovio_sfm
