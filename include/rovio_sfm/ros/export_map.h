#pragma once

#include <rovio_sfm/ExportMap.h>

#include <optional>
#include <string>

#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// The map that a request means; nothing where there is no such map with a posed frame.
std::optional<LevelMap> FindRequestedMap(const MapSnapshot& snapshot,
                                         const ExportMapRequest& request);

// Answers the service ExportMap: writes the files below output_dir (empty: refused). Never throws;
// the status says what went wrong.
ExportMapResponse ExportMapFiles(const MapSnapshot& snapshot, const MapSource& source,
                                 const std::string& output_dir, const ExportMapRequest& request);

}  // namespace rovio_sfm
