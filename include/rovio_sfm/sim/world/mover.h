#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/sim/world/world.h"

namespace rovio_sfm::sim {

// Somebody who walks to and fro in a world.
struct MoverSpec {
  std::string world;  // name of the file, without .yaml, of the world that is the mover
  Eigen::Vector2d from_m{0, 0}, to_m{1, 0};  // on the floor
  double speed_m_s = 0.7;

  bool IsValid(std::string* error) const;
};

// Where a mover is, time_s after the first picture: it starts at from_m, faces where it goes (+x of
// its own world) and turns round at either end. Floor at z = 0.
Rigid3 PlaceOfMover(const MoverSpec& spec, double time_s);

// A small world placed in another one. It brings its own light and casts no shadow.
struct PlacedWorld {
  const World* world = nullptr;
  Rigid3 outer_from_world;
};

// Movers with their worlds.
class Movers {
 public:
  Movers() = default;  // nobody moves
  // Reads each world from a folder; throws std::runtime_error that names the file.
  Movers(const std::vector<MoverSpec>& specs, const std::string& worlds_folder);

  bool empty() const { return specs_.empty(); }
  std::vector<PlacedWorld> At(double time_s) const;

 private:
  std::vector<MoverSpec> specs_;
  std::vector<std::shared_ptr<const World>> worlds_;  // of each
};

}  // namespace rovio_sfm::sim
