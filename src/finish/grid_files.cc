#include "rovio_sfm/finish/grid_files.h"

#include <iomanip>
#include <sstream>

namespace rovio_sfm {
namespace {

// As map_saver writes them; with its thresholds 0.65 and 0.196 they read back as what they were.
char GreyOf(GridCell cell) {
  if (cell == GridCell::kFree) return static_cast<char>(254);
  return cell == GridCell::kOccupied ? static_cast<char>(0) : static_cast<char>(205);
}

}  // namespace

std::string GridPgm(const OccupancyGridMap& grid) {
  std::ostringstream out;
  out << "P5\n# rovio_sfm, " << std::setprecision(6) << grid.resolution_m << " m a pixel\n"
      << grid.width << " " << grid.height << "\n255\n";
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = 0; column < grid.width; ++column) out << GreyOf(grid.At(column, row));
  }
  return out.str();
}

std::string GridYaml(const OccupancyGridMap& grid, const std::string& picture) {
  std::ostringstream out;
  out << std::setprecision(9) << "image: " << picture << "\nresolution: " << grid.resolution_m
      << "\norigin: [" << grid.origin_m.x() << ", " << grid.origin_m.y()
      << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return out.str();
}

}  // namespace rovio_sfm
