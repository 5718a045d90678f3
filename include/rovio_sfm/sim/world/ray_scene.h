#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "rovio_sfm/sim/world/surface.h"

namespace rovio_sfm::sim {

// Where a ray meets a surface.
struct RayHit {
  int surface = -1;  // index into the surfaces, -1 for none
  float distance = 0.0f;
  float u = 0.0f, v = 0.0f;  // on the surface
};

// Eight rays from one origin each, traced together.
struct RayPacket {
  static constexpr int kSize = 8;
  Eigen::Vector3f origins[kSize];
  Eigen::Vector3f directions[kSize];  // unit length
};

// Surfaces made ready for ray casting (Embree). Immutable; any thread may trace.
class RayScene {
 public:
  explicit RayScene(const std::vector<Surface>& surfaces);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  RayHit Trace(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;
  void Trace(const RayPacket& rays, RayHit* hits) const;  // hits: RayPacket::kSize

  // True if anything lies between the two points (1 mm at either end left out).
  bool IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;
  // True if anything lies within reach_m along the direction.
  bool IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& direction,
                 float reach_m) const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace rovio_sfm::sim
