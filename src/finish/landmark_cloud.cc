#include "rovio_sfm/finish/landmark_cloud.h"

namespace rovio_sfm {
namespace {

// The mean direction, of length 1, from a point to the cameras that see it.
Eigen::Vector3d TowardsCameras(const ModelPoint& point, const MapModel& model) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const ModelView& view : point.views) {
    sum += (OriginInA(model.images[view.image].cam_from_map) - point.x_in_map).normalized();
  }
  return sum.normalized();
}

}  // namespace

PointCloud LandmarkCloud(const MapModel& model) {
  PointCloud cloud;
  for (const ModelPoint& point : model.points) {
    cloud.push_back({point.x_in_map.cast<float>(), TowardsCameras(point, model).cast<float>(),
                     point.color, static_cast<uint32_t>(point.views.size())});
  }
  return cloud;
}

}  // namespace rovio_sfm
