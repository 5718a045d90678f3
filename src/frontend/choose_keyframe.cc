#include "rovio_sfm/frontend/choose_keyframe.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/geometry/relative_pose.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr double kCornerQuality = 0.005, kCornerDistancePx = 10.0;
constexpr size_t kMinCorners = 8;  // fewer tell nothing: the overlap counts as lost

// Undistorted points of half-size pixels, where both can be undistorted.
struct PointPairs {
  std::vector<Eigen::Vector2d> a, b;
};

PointPairs Undistort(const std::vector<cv::Point2f>& small_a,
                     const std::vector<cv::Point2f>& small_b, const Camera& camera) {
  const auto full = [](const cv::Point2f& p) {
    return Eigen::Vector2d(2.0 * p.x + 0.5, 2.0 * p.y + 0.5);  // pixel centres of the area average
  };
  PointPairs pairs;
  for (size_t i = 0; i < small_a.size(); ++i) {
    const auto a = NormalizedFromPixel(camera, full(small_a[i]));
    const auto b = NormalizedFromPixel(camera, full(small_b[i]));
    if (!a || !b) continue;
    pairs.a.push_back(*a);
    pairs.b.push_back(*b);
  }
  return pairs;
}

// The rotation from all pairs, and the median flow that it leaves.
ImageMotion MotionOf(const PointPairs& pairs) {
  ImageMotion motion;
  const auto rotation = EstimateRotation(pairs.a, pairs.b);
  if (!rotation) return motion;
  std::vector<double> residuals;
  for (size_t i = 0; i < pairs.a.size(); ++i) {
    const Eigen::Vector3d turned = *rotation * pairs.a[i].homogeneous();
    residuals.push_back((turned.hnormalized() - pairs.b[i]).norm());
  }
  motion.flow_rad = Median(residuals);
  motion.rotation_rad = RotationAngle(*rotation);
  return motion;
}

}  // namespace

ImageChoice ChooseImage(const ImageMotion& motion, double sharpness_share, int num_delayed,
                        const ChooseOptions& options) {
  if (sharpness_share < options.spoilt_share) return ImageChoice::kSpoilt;
  if (options.mode == KeyframeMode::kEvery) return ImageChoice::kKeyframe;
  const bool is_wanted = motion.flow_rad >= options.min_flow_rad ||
                         motion.rotation_rad >= options.min_rotation_rad ||
                         motion.tracked_share < options.min_tracked_share;
  const bool is_put_off =
      sharpness_share < options.blurred_share && num_delayed < options.max_delay;
  return is_wanted && !is_put_off ? ImageChoice::kKeyframe : ImageChoice::kLight;
}

FlowOptions MotionTracker::PyramidOptions() {
  FlowOptions options;
  options.window_px = 15;
  return options;
}

void MotionTracker::StartFrom(const FlowPyramid& small_image) {
  last_ = small_image;
  reference_.clear();
  if (!small_image.levels.empty()) {
    cv::goodFeaturesToTrack(small_image.levels[0], reference_, options_.num_corners, kCornerQuality,
                            kCornerDistancePx);
  }
  current_ = reference_;
  num_started_ = reference_.size();
}

ImageMotion MotionTracker::Follow(const FlowPyramid& small_image, const Camera& camera) {
  const auto tracked = TrackPoints(last_, small_image, current_, {}, PyramidOptions());
  std::vector<cv::Point2f> reference, current;
  for (size_t i = 0; i < tracked.size(); ++i) {
    if (!tracked[i]) continue;
    reference.push_back(reference_[i]);
    current.push_back(*tracked[i]);
  }
  reference_ = std::move(reference);
  current_ = std::move(current);
  last_ = small_image;
  if (current_.size() < kMinCorners) return {};
  ImageMotion motion = MotionOf(Undistort(reference_, current_, camera));
  motion.tracked_share = static_cast<double>(current_.size()) / static_cast<double>(num_started_);
  return motion;
}

void KeyframeChooser::SetOptions(const ChooseOptions& options) {
  ROVIO_CHECK(options.mode == options_.mode, "the mode of a drive stays");
  options_ = options;
  tracker_.SetOptions(options);
}

double KeyframeChooser::SharpnessShare(double sharpness) {
  sharpness_.push_back(sharpness);
  while (sharpness_.size() > static_cast<size_t>(options_.sharpness_window)) sharpness_.pop_front();
  const double median = Median<double>({sharpness_.begin(), sharpness_.end()});
  return median > 0.0 ? sharpness / median : 0.0;
}

ImageChoice KeyframeChooser::Choose(const FlowPyramid& small_image, double sharpness,
                                    const Camera& camera) {
  const double share = SharpnessShare(sharpness);
  if (!has_keyframe_) {
    return share < options_.spoilt_share ? ImageChoice::kSpoilt : ImageChoice::kKeyframe;
  }
  if (options_.mode == KeyframeMode::kEvery) return ChooseImage({}, share, 0, options_);
  const ImageMotion motion = tracker_.Follow(small_image, camera);
  const ImageChoice choice = ChooseImage(motion, share, num_delayed_, options_);
  const bool is_put_off = choice == ImageChoice::kLight &&
                          ChooseImage(motion, 1.0, 0, options_) == ImageChoice::kKeyframe;
  if (is_put_off) ++num_delayed_;
  return choice;
}

void KeyframeChooser::StartFrom(const FlowPyramid& small_image) {
  has_keyframe_ = true;
  num_delayed_ = 0;
  tracker_.StartFrom(small_image);
}

}  // namespace rovio_sfm
