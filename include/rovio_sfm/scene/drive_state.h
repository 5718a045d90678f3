#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What became of the frames of a drive, or of all.
struct MapperCounters {
  uint64_t keyframes = 0;  // resected into a map, those that started it included
  uint64_t light_frames = 0;
  uint64_t weak_frames = 0;
  uint64_t missing_events = 0;  // gaps in a drive's index
  uint64_t refused_events = 0;
  uint64_t lost_sessions = 0;
  uint64_t global_adjustments = 0;
};

// Where the mapping of a drive stands, beside its sessions; frames by FrameId::index.
struct DriveState {
  struct WeakFrame {
    uint32_t index = 0;
    int num_tries = 0;
  };
  std::optional<uint32_t> next_index;  // none: no frame came yet
  std::vector<uint32_t> held;          // keyframes before the current session starts
  std::vector<WeakFrame> weak;         // of the current session, that may yet be resected
  std::vector<uint32_t> unposed;       // light frames of the current session without a pose
  std::vector<TrackLink> pending_links;
  int num_waited = 0;       // keyframes since the first pair that would do
  int num_weak_in_row = 0;  // of the newest keyframes
  MapperCounters counters;
};

struct DriveRecord {
  DriveId id;
  Camera camera;
  DriveState state;
};

}  // namespace rovio_sfm
