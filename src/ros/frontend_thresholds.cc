#include "rovio_sfm/ros/frontend_thresholds.h"

namespace rovio_sfm {
namespace {

// Calls visit(option, threshold) for every pair that means the same.
template <typename Options, typename Thresholds, typename Visit>
void ForEachThreshold(Options& options, Thresholds& thresholds, const Visit& visit) {
  visit(options.min_features, thresholds.min_features);
  visit(options.choose.num_corners, thresholds.choose_num_corners);
  visit(options.choose.min_flow_rad, thresholds.choose_min_flow_rad);
  visit(options.choose.min_rotation_rad, thresholds.choose_min_rotation_rad);
  visit(options.choose.min_tracked_share, thresholds.choose_min_tracked_share);
  visit(options.choose.blurred_share, thresholds.choose_blurred_share);
  visit(options.choose.spoilt_share, thresholds.choose_spoilt_share);
  visit(options.choose.max_delay, thresholds.choose_max_delay);
  visit(options.extract.max_features, thresholds.extract_max_features);
  visit(options.extract.sift_contrast, thresholds.extract_sift_contrast);
  visit(options.extract.min_distance_px, thresholds.extract_min_distance_px);
  visit(options.pair.max_ratio, thresholds.pair_max_ratio);
  visit(options.pair.max_mean_factor, thresholds.pair_max_mean_factor);
  visit(options.pair.verify.threshold_px, thresholds.pair_threshold_px);
  visit(options.pair.verify.min_inliers, thresholds.pair_min_inliers);
  visit(options.pair.verify.max_homography_share, thresholds.pair_max_homography_share);
  visit(options.pair.verify.min_flow_px, thresholds.pair_min_flow_px);
  visit(options.pair.use_guided, thresholds.pair_use_guided);
  visit(options.pair.guided.band_px, thresholds.pair_guided_band_px);
  visit(options.recursion.min_matches, thresholds.recursion_min_matches);
  visit(options.recursion.max_frames, thresholds.recursion_max_frames);
  visit(options.recursion.max_misses, thresholds.recursion_max_misses);
  visit(options.track.same_feature_px, thresholds.track_same_feature_px);
  visit(options.light.max_features, thresholds.light_max_features);
  visit(options.light.min_features, thresholds.light_min_features);
  visit(options.light.flow.max_backward_error_px, thresholds.light_max_backward_error_px);
}

template <typename From, typename To>
void Assign(const From& from, To* to) {
  *to = static_cast<To>(from);
}

}  // namespace

FrontendThresholdsConfig ThresholdsOf(const FrontendOptions& options) {
  FrontendThresholdsConfig thresholds = FrontendThresholdsConfig::__getDefault__();
  ForEachThreshold(options, thresholds,
                   [](const auto& option, auto& threshold) { Assign(option, &threshold); });
  return thresholds;
}

FrontendOptions WithThresholds(FrontendOptions options,
                               const FrontendThresholdsConfig& thresholds) {
  ForEachThreshold(options, thresholds,
                   [](auto& option, const auto& threshold) { Assign(threshold, &option); });
  return options;
}

}  // namespace rovio_sfm
