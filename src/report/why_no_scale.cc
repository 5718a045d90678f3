#include "rovio_sfm/report/why_no_scale.h"

namespace rovio_sfm {

void CountMotion(const FrameEvent& event, MotionCounts* counts) {
  ++counts->frames;
  counts->with_odometry += event.odometry ? 1 : 0;
  counts->with_head += event.base_from_camera ? 1 : 0;
}

std::string WhyNoScale(const MotionCounts& counts) {
  if (counts.frames == 0) return "no frame came";
  if (counts.with_odometry == 0) return "no odometry: none was there at the stamps of the images";
  if (counts.with_head == 0) return "no place of the camera on the robot: no extrinsics, no tf";
  return "odometry is there, but the robot moved too little or turned and slipped too much for it";
}

}  // namespace rovio_sfm
