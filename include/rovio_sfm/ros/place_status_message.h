#pragma once

#include <rovio_sfm/PlaceStatus.h>

#include "rovio_sfm/recognition/place_recognizer.h"

namespace rovio_sfm {

// The recognizer's counts; what the node itself counts is left 0.
PlaceStatus ToMessage(const PlaceCounters& counters);

}  // namespace rovio_sfm
