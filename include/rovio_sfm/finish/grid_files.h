#pragma once

#include <string>

#include "rovio_sfm/finish/make_grid.h"

namespace rovio_sfm {

// A grid as map_server reads it: a binary PGM, the greatest y first, 254 free, 0 occupied, 205
// unknown; and the YAML file that names the picture (a path relative to itself).
std::string GridPgm(const OccupancyGridMap& grid);
std::string GridYaml(const OccupancyGridMap& grid, const std::string& picture);

}  // namespace rovio_sfm
