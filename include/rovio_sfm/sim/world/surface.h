#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "rovio_sfm/sim/world/world_spec.h"

namespace rovio_sfm::sim {

// A quadrilateral of the world; (u, v) in [0, 1]² runs over its corners (0,0), (1,0), (1,1), (0,1).
struct Surface {
  std::array<Eigen::Vector3f, 4> corners;  // metres
  std::array<Eigen::Vector3f, 4> normals;  // for shading, unit length
  std::array<Eigen::Vector2f, 4> texels;   // where the corners lie in the texture
  int texture = 0;                         // index into WorldSpec::textures, or -1 for a lamp
  int object = -1;                         // index into WorldSpec::objects, or -1 for a lamp
  float mirror = 0.0f, gloss = 0.0f, roughness = 0.0f;
  float emission = 0.0f;  // radiance of a lamp
};

// The value at (u, v) of a quantity given at the corners.
template <typename T>
T Interpolate(const std::array<T, 4>& corners, float u, float v) {
  return (1 - v) * ((1 - u) * corners[0] + u * corners[1]) +
         v * ((1 - u) * corners[3] + u * corners[2]);
}

// All surfaces of a valid world: objects in the order of the file, then lamps. Each face gets a
// window of its own in its texture, copies of one object the same; throws std::runtime_error for a
// face that is larger than its texture (textures are never tiled).
std::vector<Surface> BuildSurfaces(const WorldSpec& world);

}  // namespace rovio_sfm::sim
