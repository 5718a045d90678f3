#include "rovio_sfm/mapping/stage_options.h"

#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

double MinParallaxRad(const MapperOptions& options) {
  return Radians(options.triangulate.min_parallax_deg);
}

}  // namespace

LandmarkLimits TriangulationLimits(const MapperOptions& options) {
  return {MinParallaxRad(options), options.triangulate.max_error_px / options.pixel_sigma_px};
}

LandmarkLimits PruningLimits(const MapperOptions& options) {
  return {MinParallaxRad(options), options.prune.max_error_px / options.pixel_sigma_px};
}

double LossSigmas(const MapperOptions& options) {
  return options.adjust.loss_px / options.pixel_sigma_px;
}

}  // namespace rovio_sfm
