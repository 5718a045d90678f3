#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What of a session changed since it was asked last, for who keeps a copy of it on disk.
struct UnsavedParts {
  bool everything = false;             // it went back to a mark: what was kept before is void
  std::set<uint32_t> poses;            // frames that came, went or stand elsewhere
  std::set<uint32_t> tracks;           // keyframes whose features lie in other tracks
  std::set<uint64_t> landmark_blocks;  // TrackId / kLandmarksPerBlock
  std::vector<TrackId> aliases;        // that came
};

}  // namespace rovio_sfm
