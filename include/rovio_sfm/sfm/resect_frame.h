#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/sfm/refine_pose.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

struct ResectFrameOptions {
  double threshold_sigmas = 3.0;  // an inlier's largest reprojection error
  int max_iterations = 300;
  double loss_sigmas = 1.0;
};

struct Resection {
  Rigid3 cam_from_map;
  std::vector<uint32_t> inliers;  // into the observations, ascending
};

// The pose of a frame from 2D-3D matches: EPnP inside RANSAC (§3.7.1), then motion-only refinement
// on the inliers, twice. Nothing where no sample gives a pose with at least 6 inliers.
std::optional<Resection> ResectFrame(const std::vector<PoseObservation>& observations,
                                     const ResectFrameOptions& options, Rng& rng);

// The same from a predicted pose instead of RANSAC: refinement, then the inliers, twice.
std::optional<Resection> ResectFromPrediction(const std::vector<PoseObservation>& observations,
                                              const Rigid3& predicted_cam_from_map,
                                              const ResectFrameOptions& options);

}  // namespace rovio_sfm
