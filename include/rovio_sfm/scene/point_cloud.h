#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// A point of a densified or dense cloud, in the level frame of its map (as cloud.ply).
struct DensePoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit, towards the cameras; zero: unknown
  Rgb color{};
  uint32_t num_views = 0;  // keyframes that agree on it
};

using PointCloud = std::vector<DensePoint>;

// A surface with coloured corners; triangles run counter-clockwise seen from outside.
struct TriangleMesh {
  PointCloud vertices;
  std::vector<std::array<uint32_t, 3>> triangles;  // indices into vertices
};

}  // namespace rovio_sfm
