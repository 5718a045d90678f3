#include "rovio_sfm/dense/estimate_depth.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/dense/project_depth.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinNeighbors = 2;
constexpr double kPixelsPerPlane = 0.75;
constexpr float kNothing = -1.0f;  // of a correlation

// Sums over the windows of a picture's brightness (CV_8U), as integers, so exactly (CV_32S).
struct WindowSums {
  cv::Mat values, squares;
};

void SumWindows(const cv::Mat& grey, int window_px, WindowSums* sums) {
  const cv::Size window(window_px, window_px);
  cv::boxFilter(grey, sums->values, CV_32S, window, {-1, -1}, false, cv::BORDER_REPLICATE);
  cv::sqrBoxFilter(grey, sums->squares, CV_32S, window, {-1, -1}, false, cv::BORDER_REPLICATE);
}

// Variance in a window times the square of its number of pixels.
float SpreadOf(int count, int sum, int squares) {
  return static_cast<float>(count * squares - sum * sum);
}

// Pixels of the neighbour from pixels of the view, for points on a plane z = depth of the view.
cv::Mat PixelsOnPlane(const PixelTransfer& transfer, double inverse_depth) {
  Eigen::Matrix3d pixels = transfer.turn;
  pixels.col(2) += transfer.shift * inverse_depth;
  cv::Mat matrix(3, 3, CV_64F);
  for (int i = 0; i < 9; ++i) matrix.at<double>(i / 3, i % 3) = pixels(i / 3, i % 3);
  return matrix;
}

// Correlates the windows of a view with its neighbours' pictures as a plane takes them there. Keeps
// its memory from plane to plane.
class Correlator {
 public:
  Correlator(const DepthView& view, const std::vector<const DepthView*>& neighbors,
             const SweepOptions& options)
      : view_(view), neighbors_(neighbors), options_(options) {
    for (const DepthView* neighbor : neighbors)
      transfers_.push_back(TransferPixels(*neighbor, view));
    WindowSums sums;
    SumWindows(view.grey, options.window_px, &sums);
    sum_ = sums.values;
    spread_.create(view.grey.size(), CV_32F);
    for (int row = 0; row < spread_.rows; ++row) {
      for (int col = 0; col < spread_.cols; ++col) {
        spread_.at<float>(row, col) =
            SpreadOf(count_, sum_.at<int>(row, col), sums.squares.at<int>(row, col));
      }
    }
  }

  // By pixel: the mean of the two best neighbours' NCC, of two neighbours the better one.
  cv::Mat Score(double inverse_depth) {
    best_.create(view_.grey.size(), CV_32F);
    second_.create(view_.grey.size(), CV_32F);
    best_.setTo(kNothing);
    second_.setTo(kNothing);
    for (size_t i = 0; i < neighbors_.size(); ++i) {
      Add(neighbors_[i]->grey, PixelsOnPlane(transfers_[i], inverse_depth));
    }
    cv::Mat score;
    if (neighbors_.size() == kMinNeighbors) {
      best_.copyTo(score);
    } else {
      cv::addWeighted(best_, 0.5, second_, 0.5, 0.0, score);
    }
    return score;
  }

  // Of the brightness in the windows of the view, squared.
  cv::Mat Variance() const { return spread_ / (count_ * count_); }

 private:
  // kNothing where a pixel lies outside of the neighbour's picture or shows no contrast there.
  void Add(const cv::Mat& neighbor_grey, const cv::Mat& pixels) {
    cv::warpPerspective(neighbor_grey, warped_, pixels, view_.grey.size(),
                        cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, 0);
    SumWindows(warped_, options_.window_px, &seen_);
    cv::multiply(view_.grey, warped_, products_, 1.0, CV_16U);
    cv::boxFilter(products_, product_sums_, CV_32S, {options_.window_px, options_.window_px},
                  {-1, -1}, false, cv::BORDER_REPLICATE);
    for (int row = 0; row < warped_.rows; ++row) AddRow(row);
  }

  void AddRow(int row) {
    const float least =
        0.25f * static_cast<float>(options_.min_contrast * options_.min_contrast * count_ * count_);
    const int *sum_a = sum_.ptr<int>(row), *sum_b = seen_.values.ptr<int>(row);
    const int* squares_b = seen_.squares.ptr<int>(row);
    const float* spread_a = spread_.ptr<float>(row);
    const int* products = product_sums_.ptr<int>(row);
    const uchar* warped = warped_.ptr<uchar>(row);
    float *best = best_.ptr<float>(row), *second = second_.ptr<float>(row);
    for (int i = 0; i < warped_.cols; ++i) {
      const auto covariance = static_cast<float>(count_ * products[i] - sum_a[i] * sum_b[i]);
      const float spread_b = SpreadOf(count_, sum_b[i], squares_b[i]);
      const float ncc = covariance / std::sqrt(std::max(spread_a[i] * spread_b, 1.0f));
      const bool is_seen = warped[i] != 0 && spread_b > least;
      const float score = is_seen ? ncc : kNothing;
      second[i] = std::max(second[i], std::min(best[i], score));
      best[i] = std::max(best[i], score);
    }
  }

  const DepthView& view_;
  const std::vector<const DepthView*>& neighbors_;
  std::vector<PixelTransfer> transfers_;  // to the neighbours
  const SweepOptions& options_;
  int count_ = options_.window_px * options_.window_px;  // pixels of a window
  cv::Mat sum_, spread_;                                 // of the view's windows
  WindowSums seen_;                                      // of the neighbour's
  cv::Mat warped_, products_, product_sums_, best_, second_;
};

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
  const auto at = static_cast<size_t>(best);
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
  const std::vector<double> planes = ChoosePlanes(view, neighbors, options.max_planes);
  Correlator correlator(view, neighbors, options);
  std::vector<cv::Mat> scores;
  for (const double inverse_depth : planes) scores.push_back(correlator.Score(inverse_depth));
  return ChooseDepths(scores, planes, correlator.Variance(), options);
}

}  // namespace rovio_sfm
