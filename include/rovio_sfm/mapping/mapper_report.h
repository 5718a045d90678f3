#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What became of one frame event.
enum class MapperOutcome : uint8_t {
  kHeld = 0,      // waits for a session to start
  kKeyframe = 1,  // in the map
  kWeak = 2,      // posed by its neighbour alone, tried again later
  kLight = 3,     // a light frame with a pose
  kUnposed = 4,   // a light frame without one; tried again at the session's end
  kRefused = 5,   // did not fit its drive; see the reason
};

// What a keyframe brought to its session.
struct MapGrowth {
  uint32_t num_created = 0;  // landmarks
  uint32_t num_found = 0;    // observations added by searching
  uint32_t num_united = 0;   // landmarks
  uint32_t num_pruned = 0;   // observations
};

struct MapperReport {
  MapperOutcome outcome = MapperOutcome::kHeld;
  std::string reason;  // of a refusal
  SessionId session;
  uint32_t num_matches = 0;  // features whose track has a landmark
  uint32_t num_inliers = 0;  // of them, in the resection
  MapGrowth growth;          // by this frame itself
};

}  // namespace rovio_sfm
