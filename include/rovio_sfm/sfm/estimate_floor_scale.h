#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// A registered camera that stands upright on the floor.
struct FloorCamera {
  Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();  // map units
  Eigen::Vector3d up_in_map = Eigen::Vector3d::UnitZ();     // length 1
  double height_m = 0.0;                                    // above the floor
};

struct FloorScaleOptions {
  double height_sigma = 0.03;
  double up_sigma_rad = 0.02;
  double max_gap_share = 0.1;
  double max_below_share = 0.1;
  double max_sigma = 0.2;
  int min_points = 30;
  int min_cameras = 5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("height_sigma", height_sigma, 0.001, 1.0, "relative, of the heights given");
    table.AddNumber("up_sigma_rad", up_sigma_rad, 0.001, 0.5, "of the mean up direction");
    table.AddNumber("max_gap_share", max_gap_share, 0.01, 0.3, "of the height: the floor's points");
    table.AddNumber("max_below_share", max_below_share, 0.01, 1.0,
                    "points under the floor per point of it");
    table.AddNumber("max_sigma", max_sigma, 0.01, 1.0, "a less certain scale is none");
    table.AddNumber("min_points", min_points, 10, 1000, "of the floor");
    table.AddNumber("min_cameras", min_cameras, 2, 100, "");
  }
};

// Metres per map unit from the known height of cameras over a flat floor (design 5.2.7): the
// cameras lie in a plane parallel to the floor; its direction comes from their centres, their up
// directions and the floor's points together, the floor from the deepest dense layer of points
// under them. sigma_log joins the fit's own uncertainty with height_sigma. Nothing where no floor
// can be found: too few points, not spread over an area, too many below, or cameras that are in no
// plane. Of many cameras and points an even choice is used.
std::optional<MapScale> EstimateFloorScale(const std::vector<FloorCamera>& cameras,
                                           const std::vector<Eigen::Vector3d>& points_in_map,
                                           const FloorScaleOptions& options);

}  // namespace rovio_sfm
