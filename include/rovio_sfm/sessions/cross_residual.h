#pragma once

#include <Eigen/Core>
#include <optional>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/sessions/find_common_landmarks.h"

namespace rovio_sfm {

// What weighs the residuals of one match under a similarity: each whitening matrix times a residual
// in normalised units is in sigmas. None where the landmark is missing.
struct CrossWeights {
  std::optional<Eigen::Matrix2d> a_in_b, b_in_a;  // landmark of a in the frame of b, and reverse
  std::optional<double> log_depth;                // of log(depth of a's / of b's), in b's frame
};

// The weights under b_from_a: a landmark whose distance is uncertain may lie anywhere along the
// epipolar line, so the residual counts little in that direction. Nothing where a landmark lies
// behind the camera that should see it, or where there is no landmark at all.
std::optional<CrossWeights> WeighMatch(const CrossMatch& match, const Sim3& b_from_a,
                                       double sigma_log_distance_floor);

// The residuals of a match in sigmas.
struct CrossResidual {
  std::optional<Eigen::Vector2d> a_in_b, b_in_a;
  std::optional<double> log_depth;

  double SquaredMax() const;  // of the three
  double SquaredSum() const;
  int NumComponents() const;
};

// Nothing as in WeighMatch.
std::optional<CrossResidual> ResidualOf(const CrossMatch& match, const Sim3& b_from_a,
                                        double sigma_log_distance_floor);

}  // namespace rovio_sfm
