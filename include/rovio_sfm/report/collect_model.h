#pragma once

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/session_table.h"

namespace rovio_sfm {

// A map as exporters write it, in its level frame: all keyframes but weak ones, and the landmarks
// that count (those of LevelCloud, in its order) with all their views; landmarks that links join
// are one point. The map is of these sessions as they are. Throws std::runtime_error naming a frame
// whose features the store does not have.
MapModel CollectModel(const LevelMap& map, const SessionTable& sessions, const FrameStore& store);

}  // namespace rovio_sfm
