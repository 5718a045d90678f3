#pragma once

#include <rovio_sfm/MapStatus.h>

#include <string>

namespace rovio_sfm {

// What mapping holds, as the JSON that the live page reads: figures, sessions, merges, warnings.
// `root` is the map that the page shows: the first that has frames; 0 for none.
std::string LiveStatus(const MapStatus& status);

}  // namespace rovio_sfm
