#pragma once

#include <functional>
#include <memory>

#include "report/small_map.h"
#include "rovio_sfm/app/mapping_engine.h"

namespace rovio_sfm {

inline MapPicture Picture(uint32_t num_sessions) {
  MapPicture picture;
  picture.snapshot = SmallMaps(num_sessions);
  return picture;
}

// The picture after something has happened to its sessions.
inline MapPicture After(const MapPicture& picture,
                        const std::function<void(MapSnapshot*)>& change) {
  MapPicture next = picture;
  MapSnapshot snapshot = *picture.snapshot;
  ++snapshot.version;
  change(&snapshot);
  next.snapshot = std::make_shared<const MapSnapshot>(snapshot);
  return next;
}

}  // namespace rovio_sfm
