#include "rovio_sfm/dense/estimate_depth.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rovio_sfm {
namespace {

constexpr size_t kMinNeighbors = 2;
constexpr double kPixelsPerPlane = 0.75;
constexpr float kNothing = -1.0f;  // of a correlation
constexpr int kFlank = 2;          // planes beside the best that are of the same peak

cv::Mat WindowMean(const cv::Mat& values, int window_px) {
  cv::Mat mean;
  cv::boxFilter(values, mean, CV_32F, {window_px, window_px}, {-1, -1}, true, cv::BORDER_REPLICATE);
  return mean;
}

// Brightness with what correlation needs of it in every window.
struct Windows {
  cv::Mat values, mean, variance;  // CV_32F
};

Windows MakeWindows(const cv::Mat& grey, int window_px) {
  Windows windows;
  grey.convertTo(windows.values, CV_32F);
  windows.mean = WindowMean(windows.values, window_px);
  windows.variance =
      WindowMean(windows.values.mul(windows.values), window_px) - windows.mean.mul(windows.mean);
  return windows;
}

// Pixels of the neighbour from pixels of the view, for points on a plane z = depth of the view.
cv::Mat PixelsOnPlane(const DepthView& view, const DepthView& neighbor, double inverse_depth) {
  const Rigid3 neighbor_from_view = neighbor.cam_from_map * Inverse(view.cam_from_map);
  Eigen::Matrix3d rays = neighbor_from_view.rotation.toRotationMatrix();
  rays.col(2) += neighbor_from_view.translation * inverse_depth;
  const Eigen::Matrix3d pixels = neighbor.pixel_from_ray * rays * view.pixel_from_ray.inverse();
  cv::Mat matrix(3, 3, CV_64F);
  for (int i = 0; i < 9; ++i) matrix.at<double>(i / 3, i % 3) = pixels(i / 3, i % 3);
  return matrix;
}

// NCC of every window of the view with the neighbour's picture as the plane takes it there;
// kNothing where that lies outside or shows no contrast.
cv::Mat Correlate(const Windows& view, const cv::Mat& neighbor_grey, const cv::Mat& pixels,
                  const SweepOptions& options) {
  cv::Mat warped;
  cv::warpPerspective(neighbor_grey, warped, pixels, view.values.size(),
                      cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, 0);
  const Windows seen = MakeWindows(warped, options.window_px);
  const cv::Mat products = WindowMean(view.values.mul(seen.values), options.window_px);
  cv::Mat energy = view.variance.mul(seen.variance), correlation;
  cv::sqrt(cv::max(energy, 1e-3), energy);
  cv::divide(products - view.mean.mul(seen.mean), energy, correlation);
  const double min_variance = 0.25 * options.min_contrast * options.min_contrast;
  correlation.setTo(kNothing, (warped == 0) | (seen.variance <= min_variance));
  return correlation;
}

// The mean of the two best neighbours (of two the better one), by pixel.
cv::Mat BestTwo(const std::vector<cv::Mat>& correlations) {
  cv::Mat best(correlations[0].size(), CV_32F, cv::Scalar(kNothing)), second = best.clone();
  for (const cv::Mat& correlation : correlations) {
    second = cv::max(second, cv::min(best, correlation));
    best = cv::max(best, correlation);
  }
  return correlations.size() == kMinNeighbors ? best : cv::Mat(0.5 * (best + second));
}

// Inverse depths of the planes, from the nearest to the farthest.
std::vector<double> ChoosePlanes(const DepthView& view,
                                 const std::vector<const DepthView*>& neighbors, int max_planes) {
  double baseline = 0.0;
  for (const DepthView* neighbor : neighbors) {
    const Rigid3 neighbor_from_view = neighbor->cam_from_map * Inverse(view.cam_from_map);
    baseline = std::max(baseline, neighbor_from_view.translation.norm());
  }
  const double first = 1.0 / view.near, last = 1.0 / view.far;
  const double shift_px = view.pixel_from_ray(0, 0) * baseline * (first - last);
  const int count = std::clamp(static_cast<int>(shift_px / kPixelsPerPlane), 8, max_planes);
  std::vector<double> planes;
  for (int i = 0; i < count; ++i) planes.push_back(first + (last - first) * i / (count - 1));
  return planes;
}

// The offset of the peak of a parabola through three neighbouring scores, in planes.
double PeakOffset(float before, float best, float after) {
  const double curvature = double{before} - 2.0 * best + after;
  if (curvature >= -1e-9) return 0.0;
  return std::clamp(0.5 * (double{before} - after) / curvature, -0.5, 0.5);
}

// One pixel's scores over the planes, and what they say.
double DepthOfScores(const std::vector<float>& scores, const std::vector<double>& planes,
                     const SweepOptions& options) {
  const auto best =
      static_cast<int>(std::max_element(scores.begin(), scores.end()) - scores.begin());
  const auto count = static_cast<int>(scores.size());
  if (best == 0 || best + 1 == count) return 0.0;
  if (scores[static_cast<size_t>(best)] < options.min_correlation) return 0.0;
  float next = kNothing;
  for (int i = 0; i < count; ++i) {
    if (std::abs(i - best) > kFlank) next = std::max(next, scores[static_cast<size_t>(i)]);
  }
  const auto at = static_cast<size_t>(best);
  if (scores[at] - next < options.min_margin) return 0.0;
  const double offset = PeakOffset(scores[at - 1], scores[at], scores[at + 1]);
  return 1.0 / (planes[at] + offset * (planes[1] - planes[0]));
}

DepthMap ChooseDepths(const std::vector<cv::Mat>& scores, const std::vector<double>& planes,
                      const cv::Mat& variance, const SweepOptions& options) {
  DepthMap depth(variance.size(), CV_32F, cv::Scalar(0));
  std::vector<float> of_pixel(planes.size());
  const double min_variance = options.min_contrast * options.min_contrast;
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      if (variance.at<float>(row, col) < min_variance) continue;
      for (size_t i = 0; i < planes.size(); ++i) of_pixel[i] = scores[i].at<float>(row, col);
      depth.at<float>(row, col) = static_cast<float>(DepthOfScores(of_pixel, planes, options));
    }
  }
  return depth;
}

}  // namespace

DepthMap EstimateDepth(const DepthView& view, const std::vector<const DepthView*>& neighbors,
                       const SweepOptions& options) {
  if (neighbors.size() < kMinNeighbors || !(view.near > 0.0) || !(view.far > view.near)) {
    return DepthMap(view.grey.size(), CV_32F, cv::Scalar(0));
  }
  const Windows windows = MakeWindows(view.grey, options.window_px);
  const std::vector<double> planes = ChoosePlanes(view, neighbors, options.max_planes);
  std::vector<cv::Mat> scores;
  for (const double inverse_depth : planes) {
    std::vector<cv::Mat> correlations;
    for (const DepthView* neighbor : neighbors) {
      const cv::Mat pixels = PixelsOnPlane(view, *neighbor, inverse_depth);
      correlations.push_back(Correlate(windows, neighbor->grey, pixels, options));
    }
    scores.push_back(BestTwo(correlations));
  }
  return ChooseDepths(scores, planes, windows.variance, options);
}

}  // namespace rovio_sfm
