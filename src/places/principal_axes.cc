#include "rovio_sfm/places/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

template <typename Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

RowMajor<float> ToMatrix(const Descriptors& descriptors) {
  const auto count = static_cast<Eigen::Index>(descriptors.Count());
  const Eigen::Map<const RowMajor<uint8_t>> bytes(descriptors.data.data(), count,
                                                  descriptors.length);
  return bytes.cast<float>();
}

}  // namespace

PrincipalAxes::PrincipalAxes(const Descriptors& descriptors, int count) {
  ROVIO_CHECK(descriptors.Count() > 0 && descriptors.metric == DescriptorMetric::kL2);
  RowMajor<float> rows = ToMatrix(descriptors);
  mean_ = rows.colwise().mean();
  rows.rowwise() -= mean_;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(rows.transpose() * rows);
  const auto kept = std::min<Eigen::Index>(count, rows.cols());
  axes_ = solver.eigenvectors().rightCols(kept);  // by ascending spread
}

FloatRows PrincipalAxes::Shorten(const Descriptors& descriptors) const {
  RowMajor<float> rows = ToMatrix(descriptors);
  rows.rowwise() -= mean_;
  const Eigen::VectorXf squared_norms = rows.rowwise().squaredNorm();
  RowMajor<float> shortened(rows.rows(), axes_.cols() + 1);
  shortened.leftCols(axes_.cols()) = rows * axes_;
  const Eigen::VectorXf along = shortened.leftCols(axes_.cols()).rowwise().squaredNorm();
  shortened.rightCols<1>() = (squared_norms - along).cwiseMax(0.0f).cwiseSqrt();
  FloatRows result;
  result.length = static_cast<uint32_t>(shortened.cols());
  result.values.assign(shortened.data(), shortened.data() + shortened.size());
  result.squared_norms.assign(squared_norms.begin(), squared_norms.end());
  return result;
}

}  // namespace rovio_sfm
