#pragma once

#include <Eigen/Core>
#include <vector>

#include "rovio_sfm/sim/world/light_map.h"
#include "rovio_sfm/sim/world/ray_scene.h"
#include "rovio_sfm/sim/world/surface.h"
#include "rovio_sfm/sim/world/texture.h"
#include "rovio_sfm/sim/world/world_spec.h"

namespace rovio_sfm::sim {

// A world built for rendering: textures drawn, light baked. Immutable; any thread may use it.
class World {
 public:
  // Needs a valid spec; throws std::runtime_error where a face does not fit its texture.
  explicit World(const WorldSpec& spec);

  const WorldSpec& spec() const { return spec_; }
  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<Texture>& textures() const { return textures_; }
  const RayScene& scene() const { return scene_; }

  // The radiance that comes back along a ray whose nearest hit is given. spread: the angle between
  // neighbouring rays (rad), for smoothing textures; chance in [0, 1)²
  // chooses texture levels and scatters rough reflections.
  Eigen::Vector3f Radiance(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                           const RayHit& hit, float spread_rad,
                           const Eigen::Vector2f& chance) const;

 private:
  Eigen::Vector3f Diffuse(const Eigen::Vector3f& direction, const RayHit& hit, float spread_rad,
                          float chance) const;

  WorldSpec spec_;
  std::vector<Surface> surfaces_;
  std::vector<Texture> textures_;
  RayScene scene_;
  std::vector<LightMap> light_maps_;
};

}  // namespace rovio_sfm::sim
