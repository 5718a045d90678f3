#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// A metric room 4 m long: cameras 0.2 m over the floor every 20 cm along x, looking along +x; a
// wall of points at x = 4 m (y from -1 to 1), points on the floor between, all seen by all cameras.
inline MapModel SmallRoom(int num_images = 5) {
  MapModel model;
  model.length_unit = "metres";
  Camera camera;
  camera.fx = camera.fy = 300.0, camera.cx = 159.5, camera.cy = 119.5;
  camera.width = 320, camera.height = 240;
  model.cameras.push_back(camera);
  Eigen::Matrix3d level_from_cam;
  level_from_cam << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  for (int i = 0; i < num_images; ++i) {
    ModelImage image;
    image.id = {{"rovio1", 1, 1}, static_cast<uint32_t>(i)};
    image.cam_from_map =
        Inverse(Rigid3{Eigen::Quaterniond(level_from_cam), {0.2 * i, 0.05 * (i % 3), 0.2}});
    model.images.push_back(image);
  }
  const auto add = [&](double x, double y, double z) {
    ModelPoint point;
    point.x_in_map = {x, y, z};
    for (int i = 0; i < num_images; ++i) {
      ModelImage& image = model.images[static_cast<size_t>(i)];
      Keypoint keypoint;
      keypoint.x_normalized = (image.cam_from_map * point.x_in_map).hnormalized();
      point.views.push_back(
          {static_cast<uint32_t>(i), static_cast<uint32_t>(image.keypoints.size())});
      image.keypoints.push_back(keypoint);
    }
    model.points.push_back(point);
  };
  for (double y = -1.0; y <= 1.0; y += 0.04) add(4.0, y, 0.2);
  for (double x = 1.5; x < 3.9; x += 0.1) {
    for (double y = -0.5; y <= 0.5; y += 0.1) add(x, y, 0.0);
  }
  return model;
}

}  // namespace rovio_sfm
