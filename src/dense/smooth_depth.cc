#include "rovio_sfm/dense/smooth_depth.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace rovio_sfm {
namespace {

constexpr int kNumFits = 3;
constexpr double kFirstReach = 0.02;  // relative, more for the first fit, which knows no slope yet

// Inverse depths of a view and how much each tells (1 / variance); both CV_64F, 0 where unknown.
struct InverseDepth {
  cv::Mat_<double> value, weight;
};

InverseDepth Invert(const MeasuredDepth& measured) {
  InverseDepth inverse{cv::Mat_<double>(measured.depth.size(), 0.0),
                       cv::Mat_<double>(measured.depth.size(), 0.0)};
  for (int row = 0; row < measured.depth.rows; ++row) {
    for (int col = 0; col < measured.depth.cols; ++col) {
      const double depth = measured.depth.at<float>(row, col);
      if (depth <= 0.0) continue;
      const double sigma = measured.sigma.at<float>(row, col) / (depth * depth);
      inverse.value(row, col) = 1.0 / depth;
      inverse.weight(row, col) = 1.0 / (sigma * sigma);
    }
  }
  return inverse;
}

// Inverse depth around a pixel: slopes per column and row, and the value at the pixel.
using InversePlane = Eigen::Vector3d;

// The pixels that a fit takes, and how far from its start, in inverse depth.
struct FitWindow {
  cv::Point center;
  int radius = 0, stride = 1;
  double reach = 0.0;
};

// Normal equations of a plane, by their different entries: this innermost loop of the smoothing is
// three times as fast as with matrices.
struct PlaneSums {
  double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0, one = 0.0, xz = 0.0, yz = 0.0, z = 0.0;
  int count = 0;

  void Add(double col, double row, double value, double weight) {
    const double wx = weight * col, wy = weight * row;
    xx += wx * col, xy += wx * row, yy += wy * row, x += wx, y += wy, one += weight;
    xz += wx * value, yz += wy * value, z += weight * value;
    ++count;
  }

  InversePlane Solve() const {
    Eigen::Matrix3d normal;
    normal << xx, xy, x, xy, yy, y, x, y, one;
    return normal.ldlt().solve(Eigen::Vector3d(xz, yz, z));
  }
};

std::optional<InversePlane> FitPlane(const InverseDepth& inverse, const InversePlane& start,
                                     const FitWindow& window, int min_pixels) {
  const cv::Point& c = window.center;
  const int last_row = std::min(inverse.value.rows - 1, c.y + window.radius);
  const int last_col = std::min(inverse.value.cols - 1, c.x + window.radius);
  const double per_reach = 1.0 / window.reach;
  PlaneSums sums;
  for (int row = std::max(0, c.y - window.radius); row <= last_row; row += window.stride) {
    const double *values = inverse.value[row], *weights = inverse.weight[row];
    for (int col = std::max(0, c.x - window.radius); col <= last_col; col += window.stride) {
      const double x = col - c.x, y = row - c.y;
      const double error = (values[col] - (start.x() * x + start.y() * y + start.z())) * per_reach;
      const double tukey = 1.0 - error * error;
      if (tukey <= 0.0 || weights[col] == 0.0) continue;
      sums.Add(x, y, values[col], tukey * tukey * weights[col]);
    }
  }
  if (sums.count < min_pixels) return std::nullopt;
  return sums.Solve();
}

// The depth of a pixel on its surface; 0 where there is none.
double SmoothedDepth(const InverseDepth& inverse, const cv::Point& pixel,
                     const SmoothingOptions& options) {
  const double here = inverse.value(pixel);
  if (here <= 0.0) return 0.0;
  const double reach = options.reach_px / std::sqrt(inverse.weight(pixel));
  InversePlane plane(0.0, 0.0, here);
  for (int fit = 0; fit < kNumFits; ++fit) {
    const FitWindow window =
        fit == 0 ? FitWindow{pixel, options.radius_px / 2, 1, 2.0 * reach + kFirstReach * here}
                 : FitWindow{pixel, options.radius_px, options.stride_px, reach};
    const auto fitted = FitPlane(inverse, plane, window, options.min_pixels);
    if (!fitted) return 0.0;
    plane = *fitted;
  }
  return std::abs(plane.z() - here) < 2.0 * reach ? 1.0 / plane.z() : 0.0;
}

}  // namespace

MeasuredDepth SmoothDepth(const MeasuredDepth& measured, const SmoothingOptions& options) {
  const InverseDepth inverse = Invert(measured);
  MeasuredDepth smooth{DepthMap(measured.depth.size(), CV_32F), measured.sigma.clone()};
  for (int row = 0; row < smooth.depth.rows; ++row) {
    for (int col = 0; col < smooth.depth.cols; ++col) {
      smooth.depth.at<float>(row, col) =
          static_cast<float>(SmoothedDepth(inverse, {col, row}, options));
    }
  }
  return smooth;
}

}  // namespace rovio_sfm
