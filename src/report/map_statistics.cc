#include "rovio_sfm/report/map_statistics.h"

#include <cmath>

namespace rovio_sfm {
namespace {

struct ErrorSums {
  double error_px = 0.0;            // of counted projections
  double squared_counted_px = 0.0;  // of counted projections, squared pixels
  double squared_normalized = 0.0;  // of landmarks with more than three views
  double squared_px = 0.0;          // the same in pixels
  double num_views = 0.0;           // l of Eq. 5.3
};

void Count(const LandmarkSnapshot& landmark, double focal_px, MapStatistics* statistics,
           ErrorSums* sums) {
  if (!IsCounted(landmark)) return;
  if (landmark.num_views == 2) ++statistics->landmarks_two_views;
  if (landmark.num_views >= 3) ++statistics->landmarks;
  if (landmark.num_views > 3) ++statistics->landmarks_over_three_views;
  statistics->projections += landmark.num_views;
  sums->error_px += landmark.mean_error_px * landmark.num_views;
  sums->squared_counted_px += landmark.squared_error_normalized * focal_px * focal_px;
}

void AddSquaredError(const LandmarkSnapshot& landmark, double focal_px, ErrorSums* sums) {
  if (landmark.num_views <= 3) return;
  sums->squared_normalized += landmark.squared_error_normalized;
  sums->squared_px += landmark.squared_error_normalized * focal_px * focal_px;
  sums->num_views += landmark.num_views;
}

}  // namespace

MapStatistics ComputeMapStatistics(const LevelMap& map) {
  MapStatistics statistics;
  for (const PosedImage& image : PosedImages(map)) {
    ++statistics.registered;
    if (image.kind == FrameKind::kKeyframe) ++statistics.registered_keyframes;
  }
  ErrorSums sums;
  for (const auto& [session, landmark] : UniteLandmarks(map)) {
    Count(landmark, session->camera.MeanFocal(), &statistics, &sums);
    AddSquaredError(landmark, session->camera.MeanFocal(), &sums);
  }
  if (statistics.projections > 0) {
    const auto num_projections = static_cast<double>(statistics.projections);
    statistics.mean_error_px = sums.error_px / num_projections;
    statistics.rms_counted_px = std::sqrt(sums.squared_counted_px / (2.0 * num_projections));
  }
  if (sums.num_views > 0.0) {
    statistics.rms_n = 1000.0 * std::sqrt(sums.squared_normalized / (2.0 * sums.num_views));
    statistics.rms_px = std::sqrt(sums.squared_px / (2.0 * sums.num_views));
  }
  return statistics;
}

}  // namespace rovio_sfm
