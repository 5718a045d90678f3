#include "rovio_sfm/frontend/light_tracks.h"

#include <algorithm>

#include "rovio_sfm/features/select_keypoints.h"
#include "rovio_sfm/util/median.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {
namespace {

constexpr float kPreferredBonus = 1e6f;  // above every detector's response

// Evenly spread indices of the features, preferred ones first within each cell.
std::vector<size_t> ChooseFeatures(const FrameFeatures& features,
                                   const std::vector<bool>& preferred, const cv::Size& size,
                                   int max_features) {
  std::vector<cv::KeyPoint> candidates;
  for (size_t i = 0; i < features.keypoints.size(); ++i) {
    const Keypoint& keypoint = features.keypoints[i];
    candidates.emplace_back(keypoint.x_px, keypoint.y_px, keypoint.size_px, 0.0f,
                            keypoint.response + (preferred[i] ? kPreferredBonus : 0.0f), 0,
                            static_cast<int>(i));
  }
  SelectOptions select;
  select.max_keypoints = max_features;
  select.max_candidates = static_cast<int>(candidates.size());
  select.min_distance_px = 4.0;
  select.border_px = 4;
  std::vector<size_t> chosen;
  for (const cv::KeyPoint& keypoint : SelectKeypoints(candidates, size, select)) {
    chosen.push_back(static_cast<size_t>(keypoint.class_id));
  }
  return chosen;
}

// The middle shift of the points found, for the guesses of those lost.
cv::Point2f MedianShift(const std::vector<cv::Point2f>& from,
                        const std::vector<std::optional<cv::Point2f>>& to) {
  std::vector<float> x, y;
  for (size_t i = 0; i < to.size(); ++i) {
    if (!to[i]) continue;
    x.push_back(to[i]->x - from[i].x);
    y.push_back(to[i]->y - from[i].y);
  }
  if (x.empty()) return {};
  return {Median(std::move(x)), Median(std::move(y))};
}

}  // namespace

bool LightOptions::IsValid(std::string* error) const {
  OptionChecker checker("light", error);
  checker.Range("max_features", max_features, 10, 2000);
  checker.Range("min_features", min_features, 1, max_features);
  checker.Nested(flow);
  return checker.Passed();
}

void LightTracks::StartFrom(const FlowPyramid& image, std::shared_ptr<const FrameFeatures> features,
                            const std::vector<TrackId>& tracks,
                            const std::vector<bool>& preferred) {
  keyframe_ = image;
  features_ = std::move(features);
  tracks_ = tracks;
  chosen_ = ChooseFeatures(*features_, preferred, image.size, options_.max_features);
  in_keyframe_.clear();
  for (const size_t i : chosen_) {
    in_keyframe_.emplace_back(features_->keypoints[i].x_px, features_->keypoints[i].y_px);
  }
  guess_ = in_keyframe_;
}

LightFeatures LightTracks::Follow(const FlowPyramid& image, const Camera& camera) {
  const auto tracked = TrackPoints(keyframe_, image, in_keyframe_, guess_, options_.flow);
  const cv::Point2f shift = MedianShift(guess_, tracked);
  LightFeatures light;
  for (size_t i = 0; i < tracked.size(); ++i) {
    guess_[i] = tracked[i] ? *tracked[i] : guess_[i] + shift;
    if (!tracked[i]) continue;
    const auto x_normalized = NormalizedFromPixel(camera, {tracked[i]->x, tracked[i]->y});
    if (!x_normalized) continue;
    Keypoint keypoint = features_->keypoints[chosen_[i]];
    keypoint.x_px = tracked[i]->x;
    keypoint.y_px = tracked[i]->y;
    keypoint.x_normalized = *x_normalized;
    light.features.keypoints.push_back(keypoint);
    light.features.colors.push_back(features_->colors[chosen_[i]]);
    light.tracks.push_back(tracks_[chosen_[i]]);
  }
  return light;
}

}  // namespace rovio_sfm
