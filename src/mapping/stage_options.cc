#include "rovio_sfm/mapping/stage_options.h"

#include <cmath>

namespace rovio_sfm {
namespace {

double MinParallaxRad(const MapperOptions& options) {
  return options.triangulate.min_parallax_deg * M_PI / 180.0;
}

}  // namespace

TriangulateTracksOptions TriangulateOptionsOf(const MapperOptions& options) {
  return {MinParallaxRad(options), options.triangulate.max_error_px / options.pixel_sigma_px};
}

PruneLandmarksOptions PruneOptionsOf(const MapperOptions& options) {
  return {options.prune.max_error_px / options.pixel_sigma_px, MinParallaxRad(options)};
}

std::optional<PlanarMotion> PlanarMotionOf(const AdjustOptions& options,
                                           const std::optional<MapScale>& scale) {
  if (!options.planar_motion) return std::nullopt;
  PlanarMotion planar;
  planar.tilt_sigma_rad = options.tilt_sigma_deg * M_PI / 180.0;
  planar.height_sigma_m = options.height_sigma_m;
  if (scale) planar.metres_per_unit = scale->metres_per_unit;
  return planar;
}

}  // namespace rovio_sfm
