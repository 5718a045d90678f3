#pragma once

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/sfm/prune_landmarks.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {

// What the mapper's options say of landmarks: pixels become sigmas, degrees radians.
LandmarkLimits TriangulationLimits(const MapperOptions& options);
LandmarkLimits PruningLimits(const MapperOptions& options);
double LossSigmas(const MapperOptions& options);  // of the robust loss

}  // namespace rovio_sfm
