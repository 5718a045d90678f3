#pragma once

#include <array>
#include <vector>

#include "rovio_sfm/sfm/adjust_bundle.h"
#include "rovio_sfm/sfm/reprojection_cost.h"

namespace ceres {
class Problem;
}

namespace rovio_sfm {

// The floor as Ceres sees it: the plane normal . x = offset in the map, through the origins of the
// robot's base, and how the base is tilted against its own extrinsics (radians about -y and x).
struct FloorBlocks {
  std::array<double, 3> normal{};  // length 1
  double offset = 0.0;             // map units
  std::array<double, 2> mount_tilt{};
};

// Adds the residuals of PlanarMotion for every camera that has a base_from_camera and a pose in the
// problem, with the floor fitted to them as a start. Nothing where there is none. The floor must
// outlive the problem.
void AddPlanarMotion(const std::vector<BundleCamera>& cameras, const PlanarMotion& planar,
                     std::vector<PoseBlock>* poses, FloorBlocks* floor, ceres::Problem* problem);

}  // namespace rovio_sfm
