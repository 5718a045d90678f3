#pragma once

#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

// The mean direction, of length 1, from a point of the model to the cameras that see it.
Eigen::Vector3d TowardsCameras(const ModelPoint& point, const MapModel& model);

// The points of a model as a cloud, in their order; normals point towards the cameras
// that see them.
PointCloud LandmarkCloud(const MapModel& model);

}  // namespace rovio_sfm
