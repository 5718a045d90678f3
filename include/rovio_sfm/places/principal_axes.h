#pragma once

#include <Eigen/Core>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/util/byte_products.h"

namespace rovio_sfm {

// The few directions along which descriptors spread most. Coordinates along them bound how near two
// descriptors may lie, at a part of the cost of all their bytes.
class PrincipalAxes {
 public:
  PrincipalAxes() = default;
  // Of metric L2, at least one; at most `count` axes.
  PrincipalAxes(const Descriptors& descriptors, int count);

  // Coordinates of each descriptor about the mean, and then how far it lies off the axes; beside
  // them the squared distance from the mean. The product of two such rows is at least that of the
  // descriptors about the mean (Cauchy-Schwarz for what lies off the axes).
  FloatRows Shorten(const Descriptors& descriptors) const;

 private:
  Eigen::RowVectorXf mean_;
  Eigen::MatrixXf axes_;  // columns
};

}  // namespace rovio_sfm
