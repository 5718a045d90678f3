#include "rovio_sfm/sim/world/read_placement.h"

#include <vector>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {

Rigid3 ReadPlacement(YamlMap* map) {
  Rigid3 placement;
  if (map->Has("at_m")) {
    const std::vector<double> at_m = map->Numbers("at_m", 3);
    placement.translation = {at_m[0], at_m[1], at_m[2]};
  }
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  placement.rotation = AngleAxisd(Radians(map->Number("yaw_deg", 0.0)), Vector3d::UnitZ()) *
                       AngleAxisd(Radians(map->Number("pitch_deg", 0.0)), Vector3d::UnitY()) *
                       AngleAxisd(Radians(map->Number("roll_deg", 0.0)), Vector3d::UnitX());
  return placement;
}

}  // namespace rovio_sfm::sim
