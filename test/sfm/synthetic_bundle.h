#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/sfm/adjust_bundle.h"
#include "synthetic/synthetic_session.h"

namespace rovio_sfm {

inline const BundleOptions kExact{50, 1.0, 1e-14};

// Cameras on a circle round the points.
inline SyntheticWorld MakeWorld(double noise_px, int num_cams = 6) {
  SyntheticOptions options;
  options.num_points = 120;
  options.num_cams = num_cams;
  options.motion = SyntheticMotion::kCircle;
  options.step = 0.4;
  options.noise_px = noise_px;
  return MakeSyntheticWorld(options);
}

// The true world as a problem; points that are seen once are left out.
inline BundleProblem MakeProblem(const SyntheticWorld& world) {
  BundleProblem problem;
  for (const Rigid3& pose : world.cams_from_map) problem.cameras.push_back({pose, false});
  problem.points = world.points;
  const Session session = MakeMappedSession(world);
  for (uint32_t cam = 0; cam < world.views.size(); ++cam) {
    for (const SyntheticView& view : world.views[cam]) {
      if (session.FindLandmark(TrackOfPoint(view.point)) == nullptr) continue;  // seen once
      problem.observations.push_back(
          {cam, view.point, 1.0 / world.camera.MeanFocal(), view.x_normalized});
    }
  }
  return problem;
}

// Moves all cameras but the first `num_kept`, and all points.
inline void Disturb(BundleProblem* problem, size_t num_kept) {
  Rng rng(5);
  for (size_t i = num_kept; i < problem->cameras.size(); ++i) {
    Rigid3& pose = problem->cameras[i].cam_from_map;
    pose = PerturbPose(pose, 0.01, 0.02, rng);
  }
  for (Eigen::Vector3d& point : problem->points) {
    const double x = rng.Gaussian(), y = rng.Gaussian(), z = rng.Gaussian();
    point += 0.02 * Eigen::Vector3d(x, y, z);
  }
}

inline std::vector<Eigen::Vector3d> Centers(const BundleProblem& problem) {
  std::vector<Eigen::Vector3d> centers;
  for (const BundleCamera& camera : problem.cameras) {
    centers.push_back(OriginInA(camera.cam_from_map));
  }
  return centers;
}

// The largest distance of the camera centres from the truth after the best similarity.
inline double ErrorUpToSimilarity(const BundleProblem& problem, const SyntheticWorld& world) {
  const auto centers = Centers(problem), truth = Centers(MakeProblem(world));
  const auto truth_from_map = AlignPoints(centers, truth);
  if (!truth_from_map) return HUGE_VAL;
  double worst = 0.0;
  for (size_t i = 0; i < centers.size(); ++i) {
    worst = std::max(worst, (*truth_from_map * centers[i] - truth[i]).norm());
  }
  return worst;
}

}  // namespace rovio_sfm
