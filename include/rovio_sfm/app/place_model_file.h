#pragma once

#include <filesystem>
#include <memory>

#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/places/place_model.h"

namespace rovio_sfm {

// Reads a place model in one go. Throws std::runtime_error naming file, field and value for what is
// missing, cut short, corrupt, of another version, or not a valid model.
std::shared_ptr<const PlaceModel> LoadPlaceModel(const std::filesystem::path& path);

// Writes all of it or nothing; throws std::runtime_error as WriteFile does.
void SavePlaceModel(const PlaceModel& model, const std::filesystem::path& path,
                    Overwrite overwrite);

}  // namespace rovio_sfm
