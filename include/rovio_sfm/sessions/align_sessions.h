#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/sessions/find_common_landmarks.h"
#include "rovio_sfm/sessions/fit_similarity.h"
#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

struct AlignOptions {
  int max_iterations = 300;
  double confidence = 0.999;
  double threshold_sigmas = 3.5;
  double loss_sigmas = 1.5;
  int min_inliers = 12;
  int min_common = 5;
  double max_sigma_log_scale = 0.1;
  double max_sigma_rotation_rad = 0.035;
  // Landmarks of one place share the errors of its cameras, which no number of them averages out:
  double sigma_log_distance_floor = 0.02;
  double sigma_log_scale_floor = 0.005;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_iterations", max_iterations, 1, 100000, "samples: few matches are false");
    table.AddNumber("confidence", confidence, 0.5, 0.999999, "that one sample had no outlier");
    table.AddNumber("threshold_sigmas", threshold_sigmas, 0.1, 100.0, "of inliers: 99.8 % in 2D");
    table.AddNumber("loss_sigmas", loss_sigmas, 0.1, 100.0, "Cauchy loss of the refinement");
    table.AddNumber("min_inliers", min_inliers, 4, 10000, "fewer are no alignment");
    table.AddNumber("min_common", min_common, 3, 10000, "distinct, landmarks of both sessions");
    table.AddNumber("max_sigma_log_scale", max_sigma_log_scale, 1e-4, 1.0,
                    "a scale less certain than 10 % spoils the merged map");
    table.AddNumber("max_sigma_rotation_rad", max_sigma_rotation_rad, 1e-5, 1.0,
                    "2 degrees: points on one line, or in one place");
    table.AddNumber("sigma_log_distance_floor", sigma_log_distance_floor, 1e-6, 1.0,
                    "of one landmark's distance");
    table.AddNumber("sigma_log_scale_floor", sigma_log_scale_floor, 0.0, 1.0, "of its scale");
  }
};

// How session a lies in session b.
struct SessionAlignment {
  Sim3 b_from_a;
  double sigma_log_scale = 0.0;
  double sigma_rotation_rad = 0.0;  // about the worst axis
  std::vector<uint32_t> inliers;    // into the matches, ascending
  int num_common = 0;               // distinct pairs of landmarks among the inliers
  double rms_sigmas = 0.0;          // of the inliers' residuals
  bool by_resection = false;        // from a resected camera, not from 3D-3D samples
};

enum class AlignRefusal : uint8_t {
  kNone = 0,
  kTooFewMatches = 1,      // with a landmark, or with both
  kNoModel = 2,            // no sample gave a similarity: points on one line or in one place
  kTooFewInliers = 3,      // min_inliers
  kTooFewCommon = 4,       // min_common
  kScaleUncertain = 5,     // max_sigma_log_scale
  kRotationUncertain = 6,  // max_sigma_rotation_rad
  kUndetermined = 7,       // some change of the similarity changes no residual
};
const char* ToString(AlignRefusal refusal);

struct AlignReport {
  std::optional<SessionAlignment> alignment;  // refined; none where it is refused
  AlignRefusal refusal = AlignRefusal::kNone;
  int num_matches = 0, num_common = 0;  // of the input; with both landmarks
};

// 3D-3D: RANSAC over similarities from three common landmarks (Umeyama, then by reprojection), and
// RefineAlignment. The same matches, options and state of rng give the same bytes.
AlignReport AlignByPoints(const std::vector<CrossMatch>& matches, const AlignOptions& options,
                          Rng& rng);

// 2D-3D: one camera, of either session, was resected in the other's map; the scale is the median
// ratio of the depths of common landmarks in it. Then RefineAlignment.
AlignReport AlignFromPose(const std::vector<CrossMatch>& matches, const Rigid3& cam_from_a,
                          const Rigid3& cam_from_b, const AlignOptions& options);

// Minimises the robust reprojection error of a's landmarks in b's frames and of b's in a's, and the
// log ratio of the distances of common ones, all in sigmas; the inliers are chosen anew in between.
// A residual's sigma counts the feature's and that of the landmark's distance. With a scale prior
// no landmark needs to be common.
AlignReport RefineAlignment(const std::vector<CrossMatch>& matches, const Sim3& initial_b_from_a,
                            const AlignOptions& options,
                            const std::optional<ScalePrior>& scale_prior = std::nullopt);

// The similarity of this scale under which one camera has both poses.
Sim3 SimilarityFromCamera(const Rigid3& cam_from_a, const Rigid3& cam_from_b, double scale);

}  // namespace rovio_sfm
