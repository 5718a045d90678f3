#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// What frames brought of the robot's motion.
struct MotionCounts {
  uint64_t frames = 0;
  uint64_t with_odometry = 0;
  uint64_t with_head = 0;  // with the camera's place on the robot
};

void CountMotion(const FrameEvent& event, MotionCounts* counts);

// One sentence for people: why a map of these frames has no metric scale.
std::string WhyNoScale(const MotionCounts& counts);

}  // namespace rovio_sfm
