#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

// The camera that programs without our distortion model are told: the mean focal length, the
// principal point at the centre of the picture, no distortion.
Camera IdealCamera(const Camera& camera);

// An encoded picture of the camera as its ideal one would have taken it, as JPEG; black where the
// camera did not see. Throws std::runtime_error where the bytes are no picture of the camera's
// size.
std::vector<uint8_t> UndistortImage(const std::vector<uint8_t>& encoded, const Camera& camera);

// The name under which it is written: of a JPEG, whatever the picture was.
std::string UndistortedName(const std::string& name);

}  // namespace rovio_sfm
