#pragma once

#include <rovio_sfm/Status.h>

#include <cstdint>

#include "rovio_sfm/app/map_products.h"
#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// One map at one moment, to be worked on while mapping goes on.
struct TakenMap {
  Status status;  // OK; else why there is no map
  MapPicture picture;
  MapGauge gauge;
  MapModel model;
};

// The map that a session (0: the most frames) lies in. Never throws. For the engine's thread.
TakenMap TakeMap(const MappingEngine& engine, uint32_t session);

}  // namespace rovio_sfm
