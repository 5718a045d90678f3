#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// How the relative pose is found from the inliers of RANSAC (§5.1.6 of the design).
enum class PairPoseMethod : uint8_t {
  kFivePoint = 0,  // the five-point model, refined on the Sampson error
  kAlgebraic = 1,  // the thesis: normalised 8-point, algebraic minimisation (§3.5)
};

struct VerifyPairOptions {
  double threshold_px = 1.5;
  int min_inliers = 20;
  int max_iterations = 1000;
  int min_iterations = 200;
  double confidence = 0.999;
  int prosac_samples = 500;
  PairPoseMethod pose_method = PairPoseMethod::kFivePoint;
  double max_homography_share = 0.45;
  // Or below min_flow_noise_ratio times the median Sampson error: then noise explains the flow.
  double min_flow_px = 0.75;
  double min_flow_noise_ratio = 3.5;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("threshold_px", threshold_px, 0.01, 50.0, "an inlier's Sampson error");
    table.AddLiveNumber("min_inliers", min_inliers, 8, 10000, "fewer: a failed pair");
    table.AddNumber("max_iterations", max_iterations, 1, 100000, "samples");
    table.AddNumber("min_iterations", min_iterations, 0, 100000, "even if fewer seem enough");
    table.AddNumber("confidence", confidence, 0.01, 0.999999, "that one sample had no outlier");
    table.AddNumber("prosac_samples", prosac_samples, 0, 100000, "until all take part, best first");
    table.AddChoice(
        "pose_method", pose_method,
        {{"five_point", PairPoseMethod::kFivePoint}, {"algebraic", PairPoseMethod::kAlgebraic}},
        "of the essential matrix");
    table.AddLiveNumber("max_homography_share", max_homography_share, 0.01, 0.99,
                        "of both truncated scores; above, the pair is planar");
    table.AddLiveNumber("min_flow_px", min_flow_px, 0.0, 100.0, "below, the pair is a rotation");
    table.AddNumber("min_flow_noise_ratio", min_flow_noise_ratio, 0.0, 100.0,
                    "the same, times the median Sampson error");
  }
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
