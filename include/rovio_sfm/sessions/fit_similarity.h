#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/sessions/find_common_landmarks.h"

namespace rovio_sfm {

// What is known of a similarity's scale besides the matches, for example from odometry.
struct ScalePrior {
  double scale = 1.0;      // of b_from_a, above 0
  double sigma_log = 0.0;  // 1 sigma of its log, above 0
};

struct FitSimilarityOptions {
  int max_iterations = 20;
  double loss_sigmas = 1.5;  // scale of the Cauchy loss; 0: squared error
  double sigma_log_distance_floor = 0.02;
  std::optional<ScalePrior> scale_prior;
};

// The similarity near the initial one that minimises the residuals of cross_residual.h over the
// chosen matches, weighed as at the initial one. Nothing where one of them has no residual there,
// or the solver fails.
std::optional<Sim3> FitSimilarity(const std::vector<CrossMatch>& matches,
                                  const std::vector<uint32_t>& chosen, const Sim3& initial_b_from_a,
                                  const FitSimilarityOptions& options);

struct SimilarityUncertainty {
  double sigma_log_scale = 0.0;
  double sigma_rotation_rad = 0.0;  // about the worst axis
  double rms_sigmas = 0.0;          // of all residuals
};

// How well the chosen matches determine the similarity, from the curvature at it; errors larger
// than the sigmas raise it. Nothing where they do not determine it.
std::optional<SimilarityUncertainty> MeasureUncertainty(const std::vector<CrossMatch>& matches,
                                                        const std::vector<uint32_t>& chosen,
                                                        const Sim3& b_from_a,
                                                        const FitSimilarityOptions& options);

}  // namespace rovio_sfm
