#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

void ReadBootstrap(OptionReader reader, BootstrapOptions* options) {
  reader.Read("max_held_frames", &options->max_held_frames);
  reader.Read("min_inliers", &options->min_inliers);
  reader.Read("min_angle_deg", &options->min_angle_deg);
  reader.Read("wished_angle_deg", &options->wished_angle_deg);
  reader.Read("patience", &options->patience);
  reader.Read("hurry_after", &options->hurry_after);
  reader.Read("hurried_angle_deg", &options->hurried_angle_deg);
  reader.RefuseUnknown();
}

void ReadResect(OptionReader reader, ResectOptions* options) {
  reader.Read("threshold_px", &options->threshold_px);
  reader.Read("min_inliers", &options->min_inliers);
  reader.Read("max_iterations", &options->max_iterations);
  reader.RefuseUnknown();
}

void ReadTriangulate(OptionReader reader, TriangulateOptions* options) {
  reader.Read("min_parallax_deg", &options->min_parallax_deg);
  reader.Read("max_error_px", &options->max_error_px);
  reader.RefuseUnknown();
}

void ReadAdjust(OptionReader reader, AdjustOptions* options) {
  reader.Read("local_frames", &options->local_frames);
  reader.Read("running_max_iterations", &options->running_max_iterations);
  reader.Read("final_max_iterations", &options->final_max_iterations);
  reader.Read("global_growth", &options->global_growth);
  reader.Read("max_global_frames", &options->max_global_frames);
  reader.Read("loss_px", &options->loss_px);
  reader.RefuseUnknown();
}

void ReadPrune(OptionReader reader, PruneOptions* options) {
  reader.Read("max_error_px", &options->max_error_px);
  reader.Read("final_error_sigmas", &options->final_error_sigmas);
  reader.RefuseUnknown();
}

void ReadScale(OptionReader reader, ScaleOptions* options) {
  reader.Read("min_distance_m", &options->min_distance_m);
  reader.Read("max_rotation_gap_deg", &options->max_rotation_gap_deg);
  reader.Read("odometry_gain_sigma", &options->odometry_gain_sigma);
  reader.Read("sideways_sigma", &options->sideways_sigma);
  reader.Read("camera_height_m", &options->camera_height_m);
  reader.Read("camera_height_sigma", &options->camera_height_sigma);
  reader.RefuseUnknown();
}

void ReadF2(OptionReader reader, FilterF2Options* options) {
  bool mean_relative = options->method == F2Method::kMeanRelative;
  reader.Read("mean_relative", &mean_relative);
  options->method = mean_relative ? F2Method::kMeanRelative : F2Method::kReprojection;
  reader.Read("max_chi_square", &options->max_chi_square);
  reader.Read("max_relative_distance", &options->max_relative_distance);
  reader.RefuseUnknown();
}

}  // namespace

void ReadOptions(OptionReader* reader, MapOptions* options) {
  OptionReader merge = reader->Group("merge");
  ReadBootstrap(reader->Group("bootstrap"), &options->bootstrap);
  ReadResect(reader->Group("resect"), &options->resect);
  ReadTriangulate(reader->Group("triangulate"), &options->triangulate);
  ReadAdjust(reader->Group("adjust"), &options->adjust);
  ReadPrune(reader->Group("prune"), &options->prune);
  ReadScale(reader->Group("scale"), &options->scale);
  ReadF2(reader->Group("f2"), &options->f2);
  ReadOptions(&merge, &options->merge);
  reader->Read("max_weak_frames", &options->max_weak_frames);
  reader->Read("max_weak_tries", &options->max_weak_tries);
  reader->Read("pixel_sigma_px", &options->pixel_sigma_px);
  reader->Read("sigma_size_px", &options->sigma_size_px);
  reader->Read("sigma_exponent", &options->sigma_exponent);
  reader->Read("seed", &options->seed);
  reader->RefuseUnknown();
  RequireValid(*options);
}

void ReadOptions(OptionReader* reader, SensorOptions* options) {
  reader->Read("base_frame", &options->base_frame);
  reader->Read("image_latency_s", &options->image_latency_s);
  reader->Read("odom_latency_s", &options->odom_latency_s);
  reader->Read("max_odom_gap_s", &options->max_odom_gap_s);
  reader->Read("odom_memory_s", &options->odom_memory_s);
  reader->RefuseUnknown();
  RequireValid(*options);
}

}  // namespace rovio_sfm
