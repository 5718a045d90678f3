#pragma once

#include <Eigen/Core>
#include <vector>

#include "rovio_sfm/sim/world/ray_scene.h"
#include "rovio_sfm/sim/world/surface.h"
#include "rovio_sfm/sim/world/world_spec.h"

namespace rovio_sfm::sim {

// The light that falls on one surface, baked on a grid over its (u, v).
struct LightMap {
  int cols = 0, rows = 0;
  std::vector<float> irradiance;  // row by row; times albedo it is radiance

  float Sample(float u, float v) const;  // bilinear
};

// Area lights with soft shadows (stratified shadow rays), plus ambient light dimmed where other
// surfaces are near. One map per surface; the same world gives the same maps.
std::vector<LightMap> BakeLight(const WorldSpec& world, const std::vector<Surface>& surfaces,
                                const RayScene& scene);

}  // namespace rovio_sfm::sim
