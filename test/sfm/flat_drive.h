#pragma once

#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/sfm/adjust_bundle.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

inline constexpr double kFlatMetresPerUnit = 0.5;

struct FlatDriveOptions {
  int num_cams = 40;
  double turn_rad = 0.0;  // from camera to camera; 0: forward, swinging a little to both sides
  double ramp_rad = 0.0;  // slope of the second half
  double rocking_rad = 0.0;
  double rocking_m = 0.0;
  double noise_px = 0.0;
  uint64_t seed = 1;
  int points_per_cam = 6;  // few, so that the map bends
};

// A robot that drives through a corridor (or round a hall) with points to all sides, looking
// forward, 0.1 m between its cameras; as a problem at the truth, with base_from_camera.
class FlatDrive {
 public:
  explicit FlatDrive(const FlatDriveOptions& options) : options_(options), rng_(options.seed) {
    for (int i = 0; i < options.num_cams; ++i) AddCamera();
    for (int i = 0; i < options.points_per_cam * options.num_cams; ++i) AddPoint();
  }

  const BundleProblem& problem() const { return problem_; }

 private:
  static Rigid3 BaseFromCamera() {
    return {Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.08, 0.0, 0.28}};
  }

  Rigid3 Rocked(const Rigid3& world_from_base) {
    const double x = rng_.Gaussian(), y = rng_.Gaussian(), z = rng_.Gaussian();
    const Eigen::Vector3d tilt = options_.rocking_rad * Eigen::Vector3d(x, y, 0.0);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(tilt.norm(), tilt.stableNormalized()));
    return world_from_base * Rigid3{turn, {0.0, 0.0, options_.rocking_m * z}};
  }

  // 0.1 m along the floor, which turns up where the ramp begins.
  void AddCamera() {
    const double swing = options_.turn_rad == 0.0 ? 0.1 * std::cos(0.5 * num_steps_) : 0.0;
    const double yaw_rad = options_.turn_rad == 0.0 ? swing - last_swing_ : options_.turn_rad;
    last_swing_ = swing;
    const double slope_rad = ++num_steps_ == options_.num_cams / 2 ? -options_.ramp_rad : 0.0;
    world_from_base_ =
        world_from_base_ *
        Rigid3{Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                   Eigen::Quaterniond(Eigen::AngleAxisd(slope_rad, Eigen::Vector3d::UnitY())),
               {0.1, 0.0, 0.0}};
    BundleCamera camera;
    camera.cam_from_map = Inverse(Rocked(world_from_base_) * BaseFromCamera());
    camera.cam_from_map.translation /= kFlatMetresPerUnit;
    camera.base_from_camera = BaseFromCamera();
    problem_.cameras.push_back(camera);
  }

  // Before one of the cameras, seen by all that have it in view; not at all by fewer than two.
  void AddPoint() {
    const Rigid3& cam_from_map =
        problem_.cameras[rng_.UniformInt(static_cast<uint32_t>(options_.num_cams))].cam_from_map;
    const double x = rng_.Uniform(-0.45, 0.45), y = rng_.Uniform(-0.35, 0.35);
    const double depth = rng_.Uniform(1.0, kSight);
    const Eigen::Vector3d point = Inverse(cam_from_map) * (depth * Eigen::Vector3d(x, y, 1.0));
    std::vector<BundleObservation> seen;
    for (uint32_t i = 0; i < problem_.cameras.size(); ++i) {
      const Eigen::Vector3d x_in_cam = problem_.cameras[i].cam_from_map * point;
      if (x_in_cam.z() < 0.8 || x_in_cam.z() > kSight) continue;
      const double u = rng_.Gaussian(), v = rng_.Gaussian();
      const Eigen::Vector2d noise = options_.noise_px * kSigma * Eigen::Vector2d(u, v);
      const Eigen::Vector2d at = x_in_cam.hnormalized() + noise;
      if (std::abs(at.x()) > 0.5 || std::abs(at.y()) > 0.38) continue;
      seen.push_back({i, static_cast<uint32_t>(problem_.points.size()), at, kSigma});
    }
    if (seen.size() < 2) return;
    problem_.points.push_back(point);
    problem_.observations.insert(problem_.observations.end(), seen.begin(), seen.end());
  }

  static constexpr double kSight = 3.0;          // map units
  static constexpr double kSigma = 1.0 / 620.0;  // one pixel

  FlatDriveOptions options_;
  Rng rng_;
  int num_steps_ = 0;
  double last_swing_ = 0.0;
  Rigid3 world_from_base_;
  BundleProblem problem_;
};

// The origins of the base, m.
inline std::vector<Eigen::Vector3d> BaseOrigins(const BundleProblem& problem) {
  std::vector<Eigen::Vector3d> origins;
  for (const BundleCamera& camera : problem.cameras) {
    Rigid3 cam_from_map = camera.cam_from_map;
    cam_from_map.translation *= kFlatMetresPerUnit;
    origins.push_back(OriginInA(*camera.base_from_camera * cam_from_map));
  }
  return origins;
}

// RMS distance of the base's origins from their best plane, m.
inline double OffPlane(const BundleProblem& problem) {
  const std::vector<Eigen::Vector3d> origins = BaseOrigins(problem);
  const double count = static_cast<double>(origins.size());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& origin : origins) middle += origin / count;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& origin : origins) {
    scatter += (origin - middle) * (origin - middle).transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
}

// RMS distance of the base's origins from the true ones after the best similarity, m.
inline double RmsError(const BundleProblem& problem, const BundleProblem& truth) {
  const auto origins = BaseOrigins(problem), true_origins = BaseOrigins(truth);
  const auto truth_from_map = AlignPoints(origins, true_origins);
  if (!truth_from_map) return HUGE_VAL;
  double sum = 0.0;
  for (size_t i = 0; i < origins.size(); ++i) {
    sum += (*truth_from_map * origins[i] - true_origins[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(origins.size()));
}

}  // namespace rovio_sfm
