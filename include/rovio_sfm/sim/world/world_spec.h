#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/sim/world/texture_spec.h"

namespace rovio_sfm::sim {

enum class PartShape { kBox, kLathe, kPanel };

// A solid of an object. Box: size_m about the middle of its lower face. Panel: size_m.y() wide and
// size_m.z() high about its middle, facing +x. Lathe: profile of (radius m, z m) turned about z.
struct PartSpec {
  PartShape shape = PartShape::kBox;
  Rigid3 object_from_part;  // metres
  Eigen::Vector3d size_m = Eigen::Vector3d::Ones();
  std::vector<Eigen::Vector2d> profile_m;  // at least two points
  int sides = 24;                          // of the lathe, even, 6 … 64
  std::string texture;
  double mirror = 0.0;     // share reflected at every angle, 0 … 1
  double gloss = 0.0;      // strength of the reflection at grazing angles, 0 … 1
  double roughness = 0.0;  // spread of the reflection, 0 … 0.5
};

// Placed more than once, an object has identical copies: same shape, same texture.
struct ObjectSpec {
  std::string name;
  std::vector<PartSpec> parts;
  std::vector<Rigid3> world_from_object;
};

// A rectangle that shines to the side it faces (+x of its own frame).
struct LightSpec {
  Rigid3 world_from_light;
  Eigen::Vector2d size_m{1.0, 1.0};  // along its y and z
  double radiance = 1.0;             // of the surface, in units where a white image is about 1
};

// What a world's YAML file says. World: metres, z up, floor at z = 0.
struct WorldSpec {
  std::string name;
  uint64_t seed = 0;
  double ambient = 0.2;        // irradiance of a surface that sees no object near it
  double light_cell_m = 0.06;  // grain of the baked light
  std::vector<TextureSpec> textures;
  std::vector<LightSpec> lights;
  std::vector<ObjectSpec> objects;

  bool IsValid(std::string* error) const;
};

// The world at another time of day: every light, and what is left of it in the corners, brighter or
// darker by up to a stop. 0: as its file says.
WorldSpec InLight(WorldSpec spec, uint64_t time_of_day);

}  // namespace rovio_sfm::sim
