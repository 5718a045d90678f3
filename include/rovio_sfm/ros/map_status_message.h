#pragma once

#include <rovio_sfm/MapStatus.h>

#include <cstdint>

#include "rovio_sfm/app/mapping_engine.h"

namespace rovio_sfm {

// What came in but never became part of a map.
struct IngestCounters {
  uint64_t refused = 0;  // frame events
  uint64_t dropped = 0;  // frame events, queue full
  uint64_t refused_matches = 0;
};

// Everything that map_status says; of the merge reports the newest 50, and counts of all.
MapStatus ToMessage(const MapPicture& picture, const IngestCounters& counters);

}  // namespace rovio_sfm
