#pragma once

#include <rovio_sfm/MapStatus.h>

#include <cstdint>
#include <map>
#include <optional>

#include "rovio_sfm/app/changed_parts.h"
#include "rovio_sfm/app/mapping_engine.h"

namespace rovio_sfm {

// What came in but never became part of a map.
struct IngestCounters {
  uint64_t refused = 0;    // frame events
  uint64_t dropped = 0;    // frame events, queue full
  uint64_t lost_gaps = 0;  // of drives, whose frontend did not answer in time
  uint64_t refused_matches = 0;
  uint64_t dropped_matches = 0;  // queue full
};
bool operator==(const IngestCounters& a, const IngestCounters& b);

// Writes what map_status says; of the merge reports the newest 50, and counts of all. Sessions and
// maps that did not change are not counted again. Thread-compatible.
class MapStatusWriter {
 public:
  // Nothing where all is as it was at the last call.
  std::optional<MapStatus> Write(const MapPicture& picture, const IngestCounters& counters);

 private:
  template <typename Stamp, typename Summary>
  struct Counted {
    Stamp stamp;
    Summary summary;
  };

  void WriteSessions(const MapPicture& picture, MapStatus* status);
  void WriteMaps(const MapPicture& picture, MapStatus* status);

  std::optional<uint64_t> number_;  // of the last picture
  IngestCounters counters_;
  std::map<SessionId, Counted<SessionStamp, SessionSummary>> sessions_;
  std::map<MapId, Counted<MapStamp, std::optional<MapSummary>>> maps_;
};

}  // namespace rovio_sfm
