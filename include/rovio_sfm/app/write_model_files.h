#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/app/map_formats.h"
#include "rovio_sfm/finish/densify_map.h"
#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// The encoded picture of a model's image; null where it is not at hand.
using PictureSource =
    std::function<std::shared_ptr<const std::vector<uint8_t>>(const ModelImage& image)>;

struct WrittenFiles {
  std::vector<std::filesystem::path> paths;  // absolute; of a folder of pictures the folder
  std::set<FrameId> missing_pictures;        // of those that a format wants: not at hand
  std::vector<std::string> left_out;         // sentences: formats that the map cannot be written in
  std::optional<DensifyCounts> densified = {};       // where that was asked for
  std::vector<std::filesystem::path> pictures = {};  // in folders of them, absolute
};

// Writes a model below a folder in one of the formats that need one: colmap/ and colmap_text/ are
// workspaces of COLMAP (sparse/0, database.db, images/), bundler/ and nvm/ hold undistorted
// pictures (images/). pictures may be empty. Throws std::runtime_error where a file cannot be
// written or a picture be undistorted.
WrittenFiles WriteModelFiles(const MapModel& model, MapFormat format, const PictureSource& pictures,
                             const std::filesystem::path& folder, Overwrite overwrite);

}  // namespace rovio_sfm
