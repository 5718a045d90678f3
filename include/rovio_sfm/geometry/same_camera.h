#pragma once

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

// True if no pixel of one lies further from the other's than rounding can tell: of one size, focal
// lengths and centre within 1e-6 of the focal length, each distortion within 1e-6.
bool IsSameCamera(const Camera& a, const Camera& b);

}  // namespace rovio_sfm
