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

}  // namespace rovio_sfm
