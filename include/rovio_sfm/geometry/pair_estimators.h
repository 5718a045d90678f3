#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace rovio_sfm {

// Matched normalised points of two cameras, for Ransac; element i of both is one match.
struct PointPairs {
  std::vector<Eigen::Vector2d> a, b;

  uint32_t Count() const { return static_cast<uint32_t>(a.size()); }
  PointPairs Select(const std::vector<uint32_t>& indices) const;
};

// Essential matrices from five matches; residual: Sampson error. Borrows the points.
class EssentialEstimator {
 public:
  using Model = Eigen::Matrix3d;
  static constexpr int kSampleSize = 5;

  explicit EssentialEstimator(const PointPairs& points);
  uint32_t NumData() const { return points_.Count(); }
  std::vector<Model> Solve(const std::vector<uint32_t>& sample) const;
  double SquaredResidual(const Model& essential, uint32_t i) const;
  std::optional<Model> Refine(const Model& essential, const std::vector<uint32_t>& inliers) const;
  // In single precision, some 1e-4 px off.
  double TruncatedLoss(const Model& essential, double squared_threshold, double bound) const;

 private:
  const PointPairs& points_;
  Eigen::ArrayXf x_a_, y_a_, x_b_, y_b_;  // the coordinates one by one, for TruncatedLoss
};

// Homographies from four matches; residual: transfer error. Borrows the points.
class HomographyEstimator {
 public:
  using Model = Eigen::Matrix3d;
  static constexpr int kSampleSize = 4;

  explicit HomographyEstimator(const PointPairs& points) : points_(points) {}
  uint32_t NumData() const { return points_.Count(); }
  std::vector<Model> Solve(const std::vector<uint32_t>& sample) const;
  double SquaredResidual(const Model& homography, uint32_t i) const;
  std::optional<Model> Refine(const Model& homography, const std::vector<uint32_t>& inliers) const;

 private:
  const PointPairs& points_;
};

}  // namespace rovio_sfm
