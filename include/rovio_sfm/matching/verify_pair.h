#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// How the relative pose is found from the inliers of RANSAC (§5.1.6 of the design).
enum class PairPoseMethod : uint8_t {
  kFivePoint = 0,  // the five-point model, refined on the Sampson error
  kAlgebraic = 1,  // the thesis: normalised 8-point, algebraic minimisation (§3.5)
};

struct VerifyPairOptions {
  double threshold_px = 1.5;  // largest Sampson error of an inlier; (0, 50]
  int min_inliers = 20;       // fewer is a failed pair; 8 or more
  int max_iterations = 1000;  // RANSAC samples; 1 … 100 000
  // Samples drawn even if fewer seem enough, to give local optimisation a choice; 0 or more.
  int min_iterations = 200;
  double confidence = 0.999;  // of RANSAC; (0, 1)
  int prosac_samples = 500;   // samples until all matches take part, best ratio first; 0 or more
  PairPoseMethod pose_method = PairPoseMethod::kFivePoint;
  // Planar if the homography's share of both truncated scores exceeds this (ORB-SLAM); (0, 1).
  double max_homography_share = 0.45;
  // Rotation if the median flow left after removing the rotation is below min_flow_px, or below
  // min_flow_noise_ratio times the median Sampson error (then noise explains the flow); 0 or more.
  double min_flow_px = 0.75;
  double min_flow_noise_ratio = 3.5;

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
};

struct PairVerification {
  PairVerdict verdict = PairVerdict::kFailed;
  std::vector<uint32_t> inliers;     // indices of matches, ascending; empty if failed
  Rigid3 cam_b_from_cam_a;           // translation of length 1, or 0 for a rotation
  double median_parallax_rad = 0.0;  // of the inliers, after removing the rotation
  double homography_share = 0.0;     // of the truncated scores of H and E, in [0, 1]
  double median_flow_px = 0.0;       // of the inliers, after removing the best pure rotation
  int num_iterations = 0;            // RANSAC samples drawn
};

// Verifies the matches of two images by their epipolar geometry (§3.5): RANSAC on the essential
// matrix, verdict by comparing essential matrix, homography and pure rotation at one threshold,
// relative pose from the inliers. Points are normalised and indexed by feature; indices of matches
// must be valid. Deterministic for the state of rng.
PairVerification VerifyPair(const std::vector<Eigen::Vector2d>& points_a,
                            const std::vector<Eigen::Vector2d>& points_b,
                            const std::vector<FeatureMatch>& matches, double focal_px,
                            const VerifyPairOptions& options, Rng& rng);

}  // namespace rovio_sfm
