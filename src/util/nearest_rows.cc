#include "rovio_sfm/util/nearest_rows.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr Eigen::Index kNumAxes = 39;   // more cost more than they rule out
constexpr Eigen::Index kSample = 5000;  // rows that tell the axes
constexpr float kRounding = 1e-5f;      // of squared lengths, generously
constexpr Eigen::Index kBlock = 16;     // rows ruled out at once
constexpr uint32_t kMaxLength = 512;    // bytes of a row

template <typename Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

RowMajor<float> ToMatrix(const std::vector<uint8_t>& bytes, uint32_t length) {
  const auto count = static_cast<Eigen::Index>(bytes.size() / length);
  return Eigen::Map<const RowMajor<uint8_t>>(bytes.data(), count, length).cast<float>();
}

// Along which rows about their mean spread most: columns.
Eigen::MatrixXf PrincipalAxes(const RowMajor<float>& rows) {
  const Eigen::Index step = 1 + (rows.rows() - 1) / kSample;
  RowMajor<float> sample(1 + (rows.rows() - 1) / step, rows.cols());
  for (Eigen::Index i = 0; i < sample.rows(); ++i) sample.row(i) = rows.row(i * step);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(sample.transpose() * sample);
  return solver.eigenvectors().rightCols(std::min(kNumAxes, rows.cols()));  // by ascending spread
}

// Coordinates of each row along the axes, and then how far it lies off them; beside them its
// squared length. The product of two such rows is at least that of the whole rows (Cauchy-Schwarz
// for what lies off the axes).
FloatRows Shorten(const RowMajor<float>& about_mean, const Eigen::MatrixXf& axes) {
  const Eigen::VectorXf squared_norms = about_mean.rowwise().squaredNorm();
  RowMajor<float> shortened(about_mean.rows(), axes.cols() + 1);
  shortened.leftCols(axes.cols()) = about_mean * axes;
  const Eigen::VectorXf along = shortened.leftCols(axes.cols()).rowwise().squaredNorm();
  shortened.rightCols<1>() = (squared_norms - along).cwiseMax(0.0f).cwiseSqrt();
  FloatRows result;
  result.length = static_cast<uint32_t>(shortened.cols());
  result.values.assign(shortened.data(), shortened.data() + shortened.size());
  result.squared_norms.assign(squared_norms.begin(), squared_norms.end());
  return result;
}

}  // namespace

NearestRows::NearestRows(std::vector<uint8_t> rows, uint32_t length)
    : rows_(std::move(rows)), length_(length) {
  ROVIO_CHECK(length_ > 0 && length_ <= kMaxLength && rows_.size() >= length_);
  RowMajor<float> about_mean = ToMatrix(rows_, length_);
  mean_ = about_mean.colwise().mean();
  about_mean.rowwise() -= mean_;
  axes_ = PrincipalAxes(about_mean);
  short_rows_ = Shorten(about_mean, axes_);
  const std::vector<float>& norms = short_rows_.squared_norms;
  largest_norm_ = *std::max_element(norms.begin(), norms.end());
}

// Goes through the rows in blocks: in most of them the greatest bound rules all out.
class NearestRows::Search {
 public:
  Search(const NearestRows& all, const uint8_t* point, float squared_norm)
      : all_(all),
        point_(point),
        squared_norm_(squared_norm),
        rounding_(kRounding * (squared_norm + all.largest_norm_)) {}

  // products: of the shortened rows with the shortened point.
  Two Find(const float* products) {
    const auto count = static_cast<Eigen::Index>(all_.short_rows_.Count());
    const float* norms = all_.short_rows_.squared_norms.data();
    for (Eigen::Index first = 0; first < count; first += kBlock) {
      const Eigen::Index size = std::min(kBlock, count - first);
      Eigen::Map<const Eigen::ArrayXf> product(products + first, size), norm(norms + first, size);
      nearness_.head(size) = 2.0f * product - norm;
      if (nearness_.head(size).maxCoeff() < limit_) continue;
      for (Eigen::Index i = 0; i < size; ++i) {
        if (nearness_[i] >= limit_) Compare(static_cast<uint32_t>(first + i));
      }
    }
    return two_;
  }

 private:
  void Compare(uint32_t row) {
    const int distance =
        SquaredDistance(point_, &all_.rows_[size_t{row} * all_.length_], all_.length_);
    if (distance >= two_.second) return;
    two_.second = std::max(distance, two_.least);
    if (distance < two_.least) two_.best = row;
    two_.least = std::min(distance, two_.least);
    limit_ = squared_norm_ - static_cast<float>(two_.second) - rounding_;
  }

  const NearestRows& all_;
  const uint8_t* point_;
  float squared_norm_, rounding_;
  float limit_ = -HUGE_VALF;
  Eigen::Array<float, kBlock, 1> nearness_;
  Two two_{0, INT32_MAX, INT32_MAX};
};

void NearestRows::ForEachTwo(const std::vector<uint8_t>& points,
                             const std::function<void(size_t, const Two&)>& visit) const {
  RowMajor<float> about_mean = ToMatrix(points, length_);
  about_mean.rowwise() -= mean_;
  const FloatRows shortened = Shorten(about_mean, axes_);
  ForEachProductRow(short_rows_, shortened, [&](size_t i, const float* products) {
    visit(i, Search(*this, &points[i * length_], shortened.squared_norms[i]).Find(products));
  });
}

}  // namespace rovio_sfm
