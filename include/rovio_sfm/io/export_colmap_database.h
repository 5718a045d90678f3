#pragma once

#include <string>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// The bytes of a COLMAP 3.8 database for the exported model: its cameras, images (with the model's
// ids) and keypoints, and two-view geometries whose matches are the features that see one point.
// Each view of a point is matched with its kMatchedViews next ones, as COLMAP's sequential matcher
// would; pairs have at least one match. No descriptors. Throws std::runtime_error if SQLite fails.
std::string ColmapDatabaseBytes(const MapModel& model);

constexpr size_t kMatchedViews = 10;

}  // namespace rovio_sfm
