#pragma once

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/sfm/prune_landmarks.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {

// The options of single stages, as the mapper's say: pixels become sigmas, degrees radians.
TriangulateTracksOptions TriangulateOptionsOf(const MapperOptions& options);
PruneLandmarksOptions PruneOptionsOf(const MapperOptions& options);

}  // namespace rovio_sfm
