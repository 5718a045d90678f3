#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

void ReadAlign(OptionReader reader, AlignOptions* options) {
  reader.Read("max_iterations", &options->max_iterations);
  reader.Read("confidence", &options->confidence);
  reader.Read("threshold_sigmas", &options->threshold_sigmas);
  reader.Read("loss_sigmas", &options->loss_sigmas);
  reader.Read("min_inliers", &options->min_inliers);
  reader.Read("min_common", &options->min_common);
  reader.Read("max_sigma_log_scale", &options->max_sigma_log_scale);
  reader.Read("max_sigma_rotation_rad", &options->max_sigma_rotation_rad);
  reader.Read("sigma_log_distance_floor", &options->sigma_log_distance_floor);
  reader.Read("sigma_log_scale_floor", &options->sigma_log_scale_floor);
  reader.RefuseUnknown();
}

void ReadSearch(OptionReader reader, SearchAcrossOptions* options) {
  reader.Read("radius_px", &options->radius_px);
  reader.Read("max_error_sigmas", &options->max_error_sigmas);
  reader.Read("max_distance", &options->max_distance);
  reader.Read("max_ratio", &options->max_ratio);
  reader.Read("max_view_angle_rad", &options->max_view_angle_rad);
  reader.Read("max_distance_ratio", &options->max_distance_ratio);
  reader.Read("min_views", &options->min_views);
  reader.RefuseUnknown();
}

void ReadEvidence(OptionReader reader, EvidenceOptions* options) {
  reader.Read("min_inliers", &options->min_inliers);
  reader.Read("grid_size", &options->grid_size);
  reader.Read("min_rows", &options->min_rows);
  reader.Read("min_columns", &options->min_columns);
  reader.Read("min_depth_ratio", &options->min_depth_ratio);
  reader.Read("min_off_plane_share", &options->min_off_plane_share);
  reader.Read("max_plane_error", &options->max_plane_error);
  reader.Read("min_visible", &options->min_visible);
  reader.Read("min_matched_share", &options->min_matched_share);
  reader.Read("refuted_share", &options->refuted_share);
  reader.Read("max_log_scale_gap", &options->max_log_scale_gap);
  reader.Read("refuted_log_scale_gap", &options->refuted_log_scale_gap);
  reader.RefuseUnknown();
}

}  // namespace

void ReadOptions(OptionReader* reader, MergeOptions* options) {
  reader->Read("automatic", &options->automatic);
  reader->Read("min_keyframes", &options->min_keyframes);
  reader->Read("seed_after", &options->seed_after);
  reader->Read("search_neighbours", &options->search_neighbours);
  reader->Read("patience", &options->patience);
  reader->Read("max_overlaps", &options->max_overlaps);
  reader->Read("max_shared_landmarks", &options->max_shared_landmarks);
  reader->Read("max_scale_gap", &options->max_scale_gap);
  reader->Read("max_rotation_gap_deg", &options->max_rotation_gap_deg);
  reader->Read("max_drift", &options->max_drift);
  reader->Read("max_gap_px", &options->max_gap_px);
  reader->Read("use_pose_graph", &options->use_pose_graph);
  ReadAlign(reader->Group("align"), &options->align);
  ReadSearch(reader->Group("search"), &options->search);
  ReadEvidence(reader->Group("evidence"), &options->evidence);
  reader->RefuseUnknown();
}

}  // namespace rovio_sfm
