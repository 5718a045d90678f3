#pragma once

#include <cstdint>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// How far two statements about the same place differ, seen from a camera.
struct LoopGap {
  double distance = 0.0;  // of the camera's centre, in its session, map units
  double log_scale = 0.0;
  double rotation_rad = 0.0;
};

// The gap at a keyframe of session b between where an overlap says that session a lies and where
// something else does.
LoopGap MeasureGap(const Session& b, uint32_t frame, const Sim3& measured_b_from_a,
                   const Sim3& known_b_from_a);

// The way of the camera over the keyframes of [first, last], map units.
double PathLength(const Session& session, uint32_t first, uint32_t last);

// The median depth of the landmarks that a keyframe observes; 0 if there is none.
double MedianDepth(const Session& session, uint32_t frame);

}  // namespace rovio_sfm
