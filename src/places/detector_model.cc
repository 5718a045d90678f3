#include "rovio_sfm/places/detector_model.h"

#include <algorithm>

namespace rovio_sfm {

WordDetector DetectorOfWord(const DetectorOptions& options, double p_z) {
  WordDetector detector;
  detector.p_z_given_e = options.p_z_given_e + (1.0 - options.p_z_given_e) * p_z;
  detector.p_z_given_not_e = std::min(options.p_z_given_not_e, 0.5 * p_z);
  detector.p_e =
      (p_z - detector.p_z_given_not_e) / (detector.p_z_given_e - detector.p_z_given_not_e);
  return detector;
}

}  // namespace rovio_sfm
