#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

struct BundleCamera {
  Rigid3 cam_from_map;
  bool fixed = false;
  uint32_t intrinsics = 0;  // into BundleProblem::intrinsics, where there are any
};

// The calibration that normalised a camera's observations, its correction (CorrectedCamera), and
// what is known of that before any picture is looked at.
struct BundleIntrinsics {
  Camera camera;
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();
  Eigen::Vector3d expected = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma = Eigen::Vector3d::Ones();
};

struct BundleObservation {
  uint32_t camera = 0;  // into BundleProblem::cameras
  uint32_t point = 0;   // into BundleProblem::points
  double sigma = 1.0;   // normalised units
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();
};

// Cameras, points and who sees whom; a copy that may be solved on any thread.
struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<Eigen::Vector3d> points;
  std::vector<BundleObservation> observations;
  std::vector<BundleIntrinsics> intrinsics;  // solved for too; none: calibrations are exact
};

struct BundleOptions {
  int max_iterations = 10;
  double loss_sigmas = 1.0;  // scale of the Cauchy loss in residuals of one sigma; 0: squared error
  double function_tolerance = 1e-5;  // stops where a step lowers the cost by a smaller share
  double max_reprojections = 0.0;    // ends there, after a few iterations at least; 0: no bound
  bool settle_points = false;  // each iteration moves every point alone to its optimum, at the end
  std::function<bool()> is_given_up = nullptr;  // asked at each iteration: nobody waits any more
};

struct BundleReport {
  bool usable = false;  // false: nothing was changed
  int iterations = 0;
  double initial_cost = 0.0, final_cost = 0.0;
  std::string message;  // why it is not usable
};

// Minimises the robust reprojection error over the free cameras, all points (§3.8.2) and the
// corrections of the intrinsics, if any. With fewer
// than two fixed cameras the gauge is held by the first camera and one component of the translation
// of the camera farthest from it. One thread and a sparse Cholesky in fixed order: same bytes every
// time. Observations behind their camera make the problem unusable: drop them first.
BundleReport AdjustBundle(BundleProblem* problem, const BundleOptions& options);

}  // namespace rovio_sfm
