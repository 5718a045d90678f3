#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// A landmark and where a frame sees it.
struct PoseObservation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();         // in the map
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();  // in the frame
  double sigma = 1.0;                                      // normalised units
};

struct RefinePoseOptions {
  int max_iterations = 20;
  double loss_sigmas = 1.0;  // scale of the Cauchy loss; 0: squared error
};

// Motion-only adjustment: the pose that minimises the robust reprojection error, by iteratively
// reweighted Gauss-Newton with step control. Points behind the camera take no part. Nothing where
// fewer than 3 points are in front of the initial camera, or they do not determine a pose.
std::optional<Rigid3> RefinePose(const std::vector<PoseObservation>& observations,
                                 const Rigid3& initial_cam_from_map,
                                 const RefinePoseOptions& options);

}  // namespace rovio_sfm
