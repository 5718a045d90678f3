#pragma once

#include <string>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// A model of VisualSFM (NVM_V3), of undistorted pictures (IdealCamera), radial distortion 0: name,
// focal length, quaternion w x y z of cam_from_map, and the camera's centre in the map; features
// are in pixels from the picture's centre, x right, y down. picture_folder stands before the names.
std::string NvmText(const MapModel& model, const std::string& picture_folder);

}  // namespace rovio_sfm
