#pragma once

#include <memory>
#include <string>

#include "rovio_sfm/places/place_model.h"

namespace rovio_sfm {

// The place model that a command was told of: a file, "none" (then null), or, with an empty name,
// the one that comes with the package (util/package_file.h). Throws std::runtime_error if it cannot
// be read.
std::shared_ptr<const PlaceModel> ReadPlaceModel(const std::string& file);

}  // namespace rovio_sfm
