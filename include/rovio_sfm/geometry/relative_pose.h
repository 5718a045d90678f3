#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm {

// The signed Sampson residual of one match and its derivatives by a left rotation (exp(w) R) and by
// the two tangent directions of the unit translation (see TranslationTangent).
struct SampsonResidual {
  double value = 0.0;  // on the plane z = 1
  Eigen::Matrix<double, 1, 5> jacobian = Eigen::Matrix<double, 1, 5>::Zero();
};

// Evaluates the Sampson residuals of one relative pose, whose translation has length 1.
class SampsonEvaluator {
 public:
  explicit SampsonEvaluator(const Rigid3& b_from_a);
  SampsonResidual Evaluate(const Eigen::Vector2d& x_a, const Eigen::Vector2d& x_b) const;

 private:
  Eigen::Matrix3d essential_;
  Eigen::Matrix3d derivatives_[5];  // of the essential matrix
};

// Two orthonormal directions normal to the unit translation, the same for the same translation.
Eigen::Matrix<double, 3, 2> TranslationTangent(const Eigen::Vector3d& translation);

// The pose changed by (w, u): rotation exp(w) R, translation moved by u along its tangent
// directions and brought back to length 1.
Rigid3 ApplyPoseStep(const Rigid3& b_from_a, const Eigen::Matrix<double, 5, 1>& step);

// Levenberg-Marquardt on the Sampson error of all matches over rotation and direction of the
// translation; never worse than the start. Nothing for fewer than 5 matches, unequal counts or a
// translation of length 0. The translation returned has length 1. With a loss_scale above 0 (on the
// plane z = 1) the errors go through Cauchy's loss of that scale.
std::optional<Rigid3> RefineRelativePose(const std::vector<Eigen::Vector2d>& points_a,
                                         const std::vector<Eigen::Vector2d>& points_b,
                                         const Rigid3& b_from_a, int max_steps = 10,
                                         double loss_scale = 0.0);

// The rotation b_from_a that best turns the rays of a onto those of b, for cameras in one place.
// Nothing for fewer than 2 matches or unequal counts.
std::optional<Eigen::Quaterniond> EstimateRotation(const std::vector<Eigen::Vector2d>& points_a,
                                                   const std::vector<Eigen::Vector2d>& points_b);

}  // namespace rovio_sfm
