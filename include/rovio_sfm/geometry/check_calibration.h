#pragma once

#include <string>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

// Of a camera as somebody gave it: is valid, and has its centre in the picture, which corrections
// may leave. Names the field, its value and what was expected.
bool IsValidCalibration(const Camera& camera, std::string* error);

}  // namespace rovio_sfm
