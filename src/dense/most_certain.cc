#include "rovio_sfm/dense/most_certain.h"

#include <cmath>

#include "rovio_sfm/dense/project_depth.h"

namespace rovio_sfm {
namespace {

constexpr double kSamePoint = 0.01;  // relative, of depths of the same, however well known

// Whether another view has measured the point of a pixel better.
bool IsBetterKnown(const Eigen::Vector2d& x_px, double depth, double sigma,
                   const PixelTransfer& there, const MeasuredDepth& theirs,
                   const CertaintyOptions& options) {
  const Eigen::Vector3d transferred = there(x_px, depth);
  const auto place = PlaceInPicture(transferred, theirs.depth.size());
  if (!place) return false;
  const cv::Point pixel = NearestPixel(*place);
  const double found = theirs.depth.at<float>(pixel);
  if (found <= 0.0 || options.max_worse * theirs.sigma.at<float>(pixel) > sigma) return false;
  const double reach = options.reach_px * sigma + kSamePoint * found;
  return std::abs(found - transferred.z()) <= reach;
}

}  // namespace

cv::Mat FindMostCertain(const DepthView& view, const MeasuredDepth& measured,
                        const std::vector<const DepthView*>& others,
                        const std::vector<const MeasuredDepth*>& theirs,
                        const CertaintyOptions& options) {
  std::vector<PixelTransfer> transfers;
  for (const DepthView* other : others) transfers.push_back(TransferPixels(*other, view));
  cv::Mat certain(measured.depth.size(), CV_8U, cv::Scalar(0));
  for (int row = 0; row < certain.rows; ++row) {
    for (int col = 0; col < certain.cols; ++col) {
      const float depth = measured.depth.at<float>(row, col);
      const float sigma = measured.sigma.at<float>(row, col);
      bool is_best = depth > 0.0f;
      for (size_t i = 0; i < others.size() && is_best; ++i) {
        is_best = !IsBetterKnown({col, row}, depth, sigma, transfers[i], *theirs[i], options);
      }
      if (is_best) certain.at<uchar>(row, col) = 255;
    }
  }
  return certain;
}

}  // namespace rovio_sfm
