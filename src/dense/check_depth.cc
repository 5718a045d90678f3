#include "rovio_sfm/dense/check_depth.h"

#include <cmath>

#include "rovio_sfm/dense/project_depth.h"

namespace rovio_sfm {
namespace {

bool Agrees(const DepthView& view, const Eigen::Vector2d& x_px, double depth,
            const DepthView& other, const DepthMap& their_depth, const AgreementOptions& options) {
  const auto there = SeePoint(other, PointOfPixel(view, x_px, depth));
  if (!there) return false;
  const double found = their_depth.at<float>(there->pixel);
  if (found <= 0.0 || std::abs(found / there->depth - 1.0) > options.max_gap) return false;
  const Eigen::Vector2d pixel(there->pixel.x, there->pixel.y);
  const auto back = SeePoint(view, PointOfPixel(other, pixel, found));
  // Rounding to their pixel takes half a pixel each way.
  return back && (back->x_px - x_px).norm() <= options.max_shift_px + 0.71;
}

}  // namespace

DepthMap KeepAgreed(const DepthView& view, const DepthMap& depth,
                    const std::vector<const DepthView*>& others,
                    const std::vector<const DepthMap*>& their_depths,
                    const AgreementOptions& options) {
  DepthMap kept(depth.size(), CV_32F, cv::Scalar(0));
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const float here = depth.at<float>(row, col);
      if (here <= 0.0f) continue;
      int num_agreed = 0;
      for (size_t i = 0; i < others.size() && num_agreed < options.min_views; ++i) {
        num_agreed += Agrees(view, {col, row}, here, *others[i], *their_depths[i], options) ? 1 : 0;
      }
      if (num_agreed >= options.min_views) kept.at<float>(row, col) = here;
    }
  }
  return kept;
}

}  // namespace rovio_sfm
