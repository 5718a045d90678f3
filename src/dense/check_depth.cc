#include "rovio_sfm/dense/check_depth.h"

#include <cmath>

#include "rovio_sfm/dense/project_depth.h"
#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

// x: the point that the view has found at x_px.
bool Agrees(const DepthView& view, const Eigen::Vector2d& x_px, const Eigen::Vector3d& x,
            const DepthView& other, const DepthMap& their_depth, const AgreementOptions& options) {
  const auto there = SeePoint(other, x);
  if (!there) return false;
  const double found = their_depth.at<float>(there->pixel);
  if (found <= 0.0 || std::abs(found / there->depth - 1.0) > options.max_gap) return false;
  const Eigen::Vector2d pixel(there->pixel.x, there->pixel.y);
  const auto back = SeePoint(view, PointOfPixel(other, pixel, found));
  // Rounding to their pixel takes half a pixel each way.
  return back && (back->x_px - x_px).norm() <= options.max_shift_px + 0.71;
}

// Whether enough of the others have found the depth of a pixel, one of them from aside.
bool IsConfirmed(const DepthView& view, const Eigen::Vector2d& x_px, double depth,
                 const std::vector<const DepthView*>& others,
                 const std::vector<const DepthMap*>& their_depths,
                 const AgreementOptions& options) {
  const Eigen::Vector3d x = PointOfPixel(view, x_px, depth);
  const Eigen::Vector3d center = OriginInA(view.cam_from_map);
  int num_agreed = 0;
  bool is_from_aside = false;
  for (size_t i = 0; i < others.size(); ++i) {
    if (!Agrees(view, x_px, x, *others[i], *their_depths[i], options)) continue;
    ++num_agreed;
    is_from_aside = is_from_aside || ParallaxAngle(center, OriginInA(others[i]->cam_from_map), x) >=
                                         options.min_angle_rad;
    if (num_agreed >= options.min_views && is_from_aside) return true;
  }
  return false;
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
      if (IsConfirmed(view, {col, row}, here, others, their_depths, options)) {
        kept.at<float>(row, col) = here;
      }
    }
  }
  return kept;
}

}  // namespace rovio_sfm
