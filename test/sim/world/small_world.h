#pragma once

#include <string>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/sim/world/load_world.h"
#include "rovio_sfm/sim/world/world.h"

namespace rovio_sfm::sim {

// A room of 3 x 3 x 2 m with a box twice, a lamp and, at x = 3, a mirror; quick to build.
inline std::string SmallWorldYaml() {
  return R"(
name: small
seed: 3
ambient: 0.4
light_cell_m: 0.4
textures:
  - {name: wall, size_px: [160, 160], texel_mm: 20, color: [200, 200, 190], accent: [90, 90, 90], contrast: 0.6}
  - {name: crate, size_px: [128, 128], texel_mm: 5, color: [180, 90, 40], accent: [60, 30, 20], contrast: 0.8, marks: [text]}
lights:
  - {at_m: [1.5, 1.5, 1.98], size_m: [0.8, 0.8], radiance: 12, pitch_deg: 90}
objects:
  - name: room
    parts:
      - {shape: panel, size_m: [3, 3], texture: wall, at_m: [1.5, 1.5, 0], pitch_deg: -90}
      - {shape: panel, size_m: [3, 2], texture: wall, at_m: [0, 1.5, 1]}
      - {shape: panel, size_m: [3, 2], texture: wall, at_m: [3, 1.5, 1], yaw_deg: 180, mirror: 0.9}
      - {shape: panel, size_m: [3, 2], texture: wall, at_m: [1.5, 0, 1], yaw_deg: 90}
      - {shape: panel, size_m: [3, 2], texture: wall, at_m: [1.5, 3, 1], yaw_deg: -90}
    placements: [{at_m: [0, 0, 0]}]
  - name: crate
    parts: [{shape: box, size_m: [0.4, 0.4, 0.4], texture: crate}]
    placements: [{at_m: [2, 1, 0]}, {at_m: [2, 2, 0], yaw_deg: 90}]
)";
}

inline WorldSpec SmallWorldSpec() { return ParseWorld(SmallWorldYaml(), "small"); }

// A camera of 64 x 48 px with the Rovio's field of view.
inline Camera SmallCamera() {
  Camera camera;
  camera.fx = 70.0;
  camera.fy = 69.0;
  camera.cx = 32.2;
  camera.cy = 22.7;
  camera.k1 = 0.021784;
  camera.k2 = -0.109756;
  camera.width = 64;
  camera.height = 48;
  return camera;
}

// A tour of 7 pictures through that room.
inline std::string SmallTourYaml() {
  return R"(
name: short
world: small
head_position: 65
exposure_stops: 1.7
way_points:
  - {x_m: 0.6, y_m: 1.5, yaw_deg: 0}
  - {x_m: 0.9, y_m: 1.5, yaw_deg: 0, frames: 3}
  - {x_m: 1.2, y_m: 1.8, yaw_deg: 90, frames: 3, arc_center_m: [0.9, 1.8]}
)";
}

}  // namespace rovio_sfm::sim
