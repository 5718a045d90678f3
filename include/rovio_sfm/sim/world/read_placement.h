#pragma once

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/util/yaml_map.h"

namespace rovio_sfm::sim {

// at_m [x, y, z], yaw_deg, pitch_deg, roll_deg (turned in the order z, y, x); missing means 0.
Rigid3 ReadPlacement(YamlMap* map);

}  // namespace rovio_sfm::sim
