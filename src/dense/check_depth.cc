#include "rovio_sfm/dense/check_depth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rovio_sfm/dense/project_depth.h"

namespace rovio_sfm {
namespace {

constexpr float kMaxStep = 0.06f;  // relative, of one surface from pixel to pixel

// Another view, as the pixels of this one see it.
struct Other {
  PixelTransfer there, back;
  Eigen::Vector3d center;  // in this view
  const DepthMap* depth;
};

std::vector<Other> RelateTo(const DepthView& view, const std::vector<const DepthView*>& others,
                            const std::vector<const DepthMap*>& their_depths) {
  std::vector<Other> related;
  for (size_t i = 0; i < others.size(); ++i) {
    related.push_back({TransferPixels(*others[i], view), TransferPixels(view, *others[i]),
                       view.cam_from_map * OriginInA(others[i]->cam_from_map), their_depths[i]});
  }
  return related;
}

// Between four pixels of one surface, on which inverse depth is even; the nearest pixel's
// elsewhere.
double DepthAt(const DepthMap& depth, const Eigen::Vector2d& x_px) {
  const int x = static_cast<int>(std::floor(x_px.x())), y = static_cast<int>(std::floor(x_px.y()));
  const double nearest = depth.at<float>(NearestPixel(x_px));
  if (x < 0 || y < 0 || x + 1 >= depth.cols || y + 1 >= depth.rows) return nearest;
  const float* above = depth.ptr<float>(y) + x;
  const float* below = depth.ptr<float>(y + 1) + x;
  const auto [least, most] = std::minmax({above[0], above[1], below[0], below[1]});
  if (least <= 0.0f || most > (1.0f + kMaxStep) * least) return nearest;
  const double u = x_px.x() - x, v = x_px.y() - y;
  return 1.0 / ((1.0 - v) * ((1.0 - u) / above[0] + u / above[1]) +
                v * ((1.0 - u) / below[0] + u / below[1]));
}

// What other views say about one pixel's depth.
class Agreement {
 public:
  Agreement(const DepthView& view, const Eigen::Vector2d& x_px, double depth)
      : x_px_(x_px),
        depth_(depth),
        point_(depth * RayOfPixel(view, x_px)),
        weight_(1.0 / (depth * depth)),
        sum_(depth * weight_) {}

  void Ask(const Other& other, const AgreementOptions& options) {
    const Eigen::Vector3d transferred = other.there(x_px_, depth_);
    const auto place = PlaceInPicture(transferred, other.depth->size());
    if (!place) return;
    const double found = DepthAt(*other.depth, *place);
    if (found <= 0.0 || std::abs(found / transferred.z() - 1.0) > options.max_gap) return;
    const Eigen::Vector3d back = other.back(*place, found);
    if (!(back.z() > 0.0) || (back.hnormalized() - x_px_).norm() > options.max_shift_px) return;
    ++num_agreed_;
    const double weight = 1.0 / (found * found);
    weight_ += weight;
    sum_ += weight * back.z();
    const Eigen::Vector3d from_other = point_ - other.center;
    const double sine_squared =
        point_.cross(from_other).squaredNorm() / (point_.squaredNorm() * from_other.squaredNorm());
    largest_sine_squared_ = std::max(largest_sine_squared_, sine_squared);
    information_ += sine_squared / from_other.squaredNorm();
  }

  bool Confirms(const AgreementOptions& options) const {
    const double sine = std::sin(options.min_angle_rad);
    return num_agreed_ >= options.min_views && largest_sine_squared_ >= sine * sine;
  }

  double MeanDepth() const { return sum_ / weight_; }

  // Along the ray, of an error of one radian.
  double Sigma() const { return 1.0 / std::sqrt(information_); }

 private:
  Eigen::Vector2d x_px_;
  double depth_;
  Eigen::Vector3d point_;  // in the view
  double weight_, sum_;
  int num_agreed_ = 0;
  double largest_sine_squared_ = 0.0, information_ = 0.0;
};

}  // namespace

MeasuredDepth KeepAgreed(const DepthView& view, const DepthMap& depth,
                         const std::vector<const DepthView*>& others,
                         const std::vector<const DepthMap*>& their_depths,
                         const AgreementOptions& options) {
  const std::vector<Other> related = RelateTo(view, others, their_depths);
  const double focal_px = view.pixel_from_ray(0, 0);
  MeasuredDepth kept{DepthMap(depth.size(), CV_32F, cv::Scalar(0)),
                     cv::Mat(depth.size(), CV_32F, cv::Scalar(0))};
  for (int row = 0; row < depth.rows; ++row) {
    for (int col = 0; col < depth.cols; ++col) {
      const float here = depth.at<float>(row, col);
      if (here <= 0.0f) continue;
      Agreement agreement(view, {col, row}, here);
      for (const Other& other : related) agreement.Ask(other, options);
      if (!agreement.Confirms(options)) continue;
      kept.depth.at<float>(row, col) = static_cast<float>(agreement.MeanDepth());
      kept.sigma.at<float>(row, col) = static_cast<float>(agreement.Sigma() / focal_px);
    }
  }
  return kept;
}

}  // namespace rovio_sfm
