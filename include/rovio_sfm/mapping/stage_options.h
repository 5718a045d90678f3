#pragma once

#include <optional>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/sfm/adjust_bundle.h"
#include "rovio_sfm/sfm/prune_landmarks.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {

// The options of single stages, as the mapper's say: pixels become sigmas, degrees radians.
TriangulateTracksOptions TriangulateOptionsOf(const MapperOptions& options);
PruneLandmarksOptions PruneOptionsOf(const MapperOptions& options);
// Of a session with this scale; nothing where the option is off.
std::optional<PlanarMotion> PlanarMotionOf(const AdjustOptions& options,
                                           const std::optional<MapScale>& scale);

}  // namespace rovio_sfm
