#pragma once

#include <cstdint>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// What each filter left of the matches of neighbouring keyframes, summed over pairs (Table 3.2).
struct MatchingFunnel {
  uint64_t pairs = 0;
  uint64_t features = 0;  // of the later frame
  uint64_t ratio = 0;     // after Lowe's ratio
  uint64_t percentile = 0;
  uint64_t one_to_one = 0;
  uint64_t ransac = 0;
  uint64_t guided = 0;
};

// Counts the event's match with its nearest earlier keyframe, if it has one.
void AddToFunnel(const FrameEvent& event, MatchingFunnel* funnel);

}  // namespace rovio_sfm
