#pragma once

#include <vector>

#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// bundle.out (v0.3) and list.txt of Bundler, of undistorted pictures (IdealCamera): k1 = k2 = 0,
// the camera looks along its -z, y up; features are in pixels from the picture's centre, y up.
// picture_folder stands before the names in the list.
std::vector<NamedFile> BundlerFiles(const MapModel& model, const std::string& picture_folder);

}  // namespace rovio_sfm
