#pragma once

namespace rovio_sfm {

// What a landmark must keep to, when it is made and as long as it stays.
struct LandmarkLimits {
  double min_parallax_rad = 0.026;  // between the two views that see it widest apart
  double max_error_sigmas = 4.0;    // reprojection error of each view
};

}  // namespace rovio_sfm
