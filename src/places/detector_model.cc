#include "rovio_sfm/places/detector_model.h"

#include <algorithm>

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool DetectorOptions::IsValid(std::string* error) const {
  OptionChecker check("detector", error);
  check.Range("p_z_given_e", p_z_given_e, 0.01, 0.99);
  check.Range("p_z_given_not_e", p_z_given_not_e, 0.0, 0.2);
  check.True("p_z_given_not_e", p_z_given_not_e < p_z_given_e, "below p_z_given_e");
  return check.Passed();
}

WordDetector DetectorOfWord(const DetectorOptions& options, double p_z) {
  WordDetector detector;
  detector.p_z_given_e = options.p_z_given_e + (1.0 - options.p_z_given_e) * p_z;
  detector.p_z_given_not_e = std::min(options.p_z_given_not_e, 0.5 * p_z);
  detector.p_e =
      (p_z - detector.p_z_given_not_e) / (detector.p_z_given_e - detector.p_z_given_not_e);
  return detector;
}

}  // namespace rovio_sfm
