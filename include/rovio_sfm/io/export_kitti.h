#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/io/trajectory_file.h"

namespace rovio_sfm {

// The poses of KITTI's odometry benchmark: a line for each pose, the upper 3x4 of first_from_camera
// by rows, where "first" is the camera (x right, y down, z forward) at map_from_first.
std::string KittiPosesText(const std::vector<StampedPose>& trajectory,
                           const Rigid3& map_from_first);
// The times of the same poses: seconds since first_ns, a line each.
std::string KittiTimesText(const std::vector<StampedPose>& trajectory, int64_t first_ns);

}  // namespace rovio_sfm
