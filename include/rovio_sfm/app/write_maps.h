#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// A map on disk.
struct WrittenMap {
  MapId id;
  size_t num_images = 0;  // registered
  bool is_metric = false;
  std::filesystem::path folder;              // absolute
  std::vector<std::filesystem::path> files;  // absolute; none: no format could be written
  std::vector<std::string> left_out;         // sentences: formats that it cannot be written in
  std::optional<DensifyCounts> densified = {};
};

// Writes every map with a registered image: the largest into the folder itself, the others by size
// into map_2, map_3 and so on in it. The folder is made. With kAllow, and where there is a map,
// what earlier runs wrote there and this one does not is removed afterwards (map_file_list.h), and
// nothing else. Throws std::runtime_error where a file cannot be written.
std::vector<WrittenMap> WriteAllMaps(const MapSnapshot& snapshot, const MapSource& source,
                                     const MapFormats& formats, const std::filesystem::path& folder,
                                     Overwrite overwrite);

// The same in the default formats.
inline std::vector<WrittenMap> WriteAllMaps(const MapSnapshot& snapshot,
                                            const std::filesystem::path& folder,
                                            Overwrite overwrite) {
  return WriteAllMaps(snapshot, {}, kDefaultFormats, folder, overwrite);
}

// For people: "map 3: 120 images, in metres, in /folder".
std::string Describe(const WrittenMap& map);

// What results a folder holds, sorted: what runs have listed, and what is where the default formats
// would write.
std::vector<std::filesystem::path> FindMapFiles(const std::filesystem::path& folder);

}  // namespace rovio_sfm
