#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

void ReadChoose(OptionReader reader, ChooseOptions* options) {
  reader.ReadChoice("mode",
                    {{"every", KeyframeMode::kEvery}, {"parallax", KeyframeMode::kParallax}},
                    &options->mode);
  reader.Read("num_corners", &options->num_corners);
  reader.Read("min_flow_rad", &options->min_flow_rad);
  reader.Read("min_rotation_rad", &options->min_rotation_rad);
  reader.Read("min_tracked_share", &options->min_tracked_share);
  reader.Read("blurred_share", &options->blurred_share);
  reader.Read("spoilt_share", &options->spoilt_share);
  reader.Read("max_delay", &options->max_delay);
  reader.Read("sharpness_window", &options->sharpness_window);
  reader.RefuseUnknown();
}

void ReadDenoise(OptionReader reader, DenoiseOptions* options) {
  reader.Read("enabled", &options->enabled);
  reader.Read("diameter_px", &options->diameter_px);
  reader.Read("sigma_color", &options->sigma_color);
  reader.Read("sigma_space_px", &options->sigma_space_px);
  reader.RefuseUnknown();
}

void ReadExtract(OptionReader reader, ExtractOptions* options) {
  reader.ReadChoice("type",
                    {{"sift", DescriptorType::kSift},
                     {"orb", DescriptorType::kOrb},
                     {"akaze", DescriptorType::kAkaze},
                     {"surf", DescriptorType::kSurf}},
                    &options->type);
  reader.Read("max_features", &options->max_features);
  reader.Read("candidate_factor", &options->candidate_factor);
  reader.Read("sift_contrast", &options->sift_contrast);
  reader.Read("sift_edge", &options->sift_edge);
  reader.Read("upsample", &options->upsample);
  reader.Read("orb_threshold", &options->orb_threshold);
  reader.Read("akaze_threshold", &options->akaze_threshold);
  reader.Read("surf_threshold", &options->surf_threshold);
  reader.Read("cell_px", &options->cell_px);
  reader.Read("min_distance_px", &options->min_distance_px);
  reader.Read("border_px", &options->border_px);
  reader.RefuseUnknown();
}

void ReadMatch(OptionReader reader, MatchOptions* options) {
  reader.ReadChoice("matcher",
                    {{"exact", Matcher::kExact},
                     {"kdtree", Matcher::kKdTree},
                     {"kmeans_tree", Matcher::kKMeansTree}},
                    &options->matcher);
  reader.Read("trees", &options->trees);
  reader.Read("branching", &options->branching);
  reader.Read("checks", &options->checks);
  reader.Read("seed", &options->seed);
  reader.RefuseUnknown();
}

void ReadVerify(OptionReader reader, VerifyPairOptions* options) {
  reader.Read("threshold_px", &options->threshold_px);
  reader.Read("min_inliers", &options->min_inliers);
  reader.Read("max_iterations", &options->max_iterations);
  reader.Read("min_iterations", &options->min_iterations);
  reader.Read("confidence", &options->confidence);
  reader.Read("prosac_samples", &options->prosac_samples);
  reader.ReadChoice(
      "pose_method",
      {{"five_point", PairPoseMethod::kFivePoint}, {"algebraic", PairPoseMethod::kAlgebraic}},
      &options->pose_method);
  reader.Read("max_homography_share", &options->max_homography_share);
  reader.Read("min_flow_px", &options->min_flow_px);
  reader.Read("min_flow_noise_ratio", &options->min_flow_noise_ratio);
  reader.RefuseUnknown();
}

void ReadGuided(OptionReader reader, GuidedOptions* options) {
  reader.Read("band_px", &options->band_px);
  reader.Read("max_ratio", &options->max_ratio);
  reader.Read("max_factor", &options->max_factor);
  reader.Read("min_depth_baselines", &options->min_depth_baselines);
  reader.RefuseUnknown();
}

void ReadOdometryGate(OptionReader reader, OdometryGateOptions* options) {
  reader.Read("enabled", &options->enabled);
  reader.Read("max_rotation_gap_deg", &options->max_rotation_gap_deg);
  reader.Read("max_direction_gap_deg", &options->max_direction_gap_deg);
  reader.Read("min_distance_m", &options->min_distance_m);
  reader.RefuseUnknown();
}

void ReadRecursion(OptionReader reader, RecursionOptions* options) {
  reader.Read("min_matches", &options->min_matches);
  reader.Read("max_frames", &options->max_frames);
  reader.Read("max_misses", &options->max_misses);
  ReadOdometryGate(reader.Group("odometry_gate"), &options->odometry_gate);
  reader.RefuseUnknown();
}

void ReadTrack(OptionReader reader, TrackOptions* options) {
  reader.Read("same_feature_px", &options->same_feature_px);
  reader.Read("remembered_frames", &options->remembered_frames);
  reader.RefuseUnknown();
}

void ReadFlow(OptionReader reader, FlowOptions* options) {
  reader.Read("window_px", &options->window_px);
  reader.Read("levels", &options->levels);
  reader.Read("max_iterations", &options->max_iterations);
  reader.Read("convergence_px", &options->convergence_px);
  reader.Read("max_backward_error_px", &options->max_backward_error_px);
  reader.Read("min_eigenvalue", &options->min_eigenvalue);
  reader.RefuseUnknown();
}

void ReadLight(OptionReader reader, LightOptions* options) {
  reader.Read("enabled", &options->enabled);
  reader.Read("max_features", &options->max_features);
  reader.Read("min_features", &options->min_features);
  ReadFlow(reader.Group("flow"), &options->flow);
  reader.RefuseUnknown();
}

}  // namespace

void ReadOptions(OptionReader* reader, PairOptions* options) {
  ReadMatch(reader->Group("match"), &options->match);
  reader->Read("max_ratio", &options->max_ratio);
  reader->Read("max_mean_factor", &options->max_mean_factor);
  ReadVerify(reader->Group("verify"), &options->verify);
  reader->Read("use_guided", &options->use_guided);
  ReadGuided(reader->Group("guided"), &options->guided);
  reader->RefuseUnknown();
}

void ReadOptions(OptionReader* reader, FrontendOptions* options) {
  OptionReader pair = reader->Group("pair");
  reader->Read("max_pixels", &options->max_pixels);
  reader->Read("min_features", &options->min_features);
  reader->Read("keep_images", &options->keep_images);
  ReadChoose(reader->Group("choose"), &options->choose);
  ReadDenoise(reader->Group("denoise"), &options->denoise);
  ReadExtract(reader->Group("extract"), &options->extract);
  ReadOptions(&pair, &options->pair);
  ReadRecursion(reader->Group("recursion"), &options->recursion);
  ReadTrack(reader->Group("track"), &options->track);
  ReadLight(reader->Group("light"), &options->light);
  reader->RefuseUnknown();
  RequireValid(*options);
}

}  // namespace rovio_sfm
