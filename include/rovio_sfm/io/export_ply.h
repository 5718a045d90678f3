#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

struct CloudPoint {
  Eigen::Vector3d x_in_map = Eigen::Vector3d::Zero();  // metres or map units
  Rgb color{};
  uint32_t session = 0;
  uint32_t num_views = 0;
  float error_px = 0.0f;  // mean reprojection error
};

// The bytes of a binary little-endian PLY: x y z red green blue session views error, one vertex per
// point, in the order given. The comment says what the lengths are ("metres", "map units").
std::string PlyBytes(const std::vector<CloudPoint>& points, const std::string& length_unit);
// The same as an ASCII PLY.
std::string PlyText(const std::vector<CloudPoint>& points, const std::string& length_unit);

// A dense cloud: x y z nx ny nz red green blue views, as binary little-endian PLY.
std::string DensePlyBytes(const PointCloud& cloud, const std::string& length_unit);
// A mesh: corners x y z nx ny nz red green blue, faces as lists of three indices.
std::string MeshPlyBytes(const TriangleMesh& mesh, const std::string& length_unit);

}  // namespace rovio_sfm
