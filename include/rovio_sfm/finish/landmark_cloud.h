#pragma once

#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

// The points of a model as a cloud, in their order; normals point towards the cameras that see
// them.
PointCloud LandmarkCloud(const MapModel& model);

}  // namespace rovio_sfm
