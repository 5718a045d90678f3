#include "rovio_sfm/geometry/check_calibration.h"

#include <sstream>

namespace rovio_sfm {
namespace {

bool IsInside(const char* field, double value_px, int size_px, std::string* error) {
  if (value_px >= 0.0 && value_px <= size_px) return true;
  std::ostringstream out;
  out << "camera " << field << " = " << value_px << ": expected 0 to " << size_px
      << " px, in the picture";
  *error = out.str();
  return false;
}

}  // namespace

bool IsValidCalibration(const Camera& camera, std::string* error) {
  return camera.IsValid(error) && IsInside("cx", camera.cx, camera.width, error) &&
         IsInside("cy", camera.cy, camera.height, error);
}

}  // namespace rovio_sfm
