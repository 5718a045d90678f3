#pragma once

#include <rovio_sfm/ExportMap.h>

#include <filesystem>
#include <string>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// Answers the service ExportMap: writes the files below output_dir (empty: refused). Never throws;
// the status says what went wrong.
ExportMapResponse ExportMapFiles(const MapSnapshot& snapshot, const std::string& output_dir,
                                 const ExportMapRequest& request);

}  // namespace rovio_sfm
