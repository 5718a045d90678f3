#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// A registered camera that stands upright on the floor.
struct FloorCamera {
  Eigen::Vector3d center_in_map = Eigen::Vector3d::Zero();  // map units
  Eigen::Vector3d up_in_map = Eigen::Vector3d::UnitZ();     // length 1
  double height_m = 0.0;                                    // above the floor
};

// How well the heights and the up directions are known.
struct FloorUncertainty {
  double height_sigma = 0.03;  // relative
  double up_sigma_rad = 0.02;  // of the mean up direction
};

// Metres per map unit from the known height of cameras over a flat floor (design 5.2.7): the
// cameras lie in a plane parallel to the floor; its direction comes from their centres, their up
// directions and the floor's points together, the floor from the deepest dense layer of points
// under them. sigma_log joins the fit's own uncertainty with height_sigma. Nothing where no floor
// can be found: too few points, not spread over an area, too many below, or cameras that are in no
// plane. Of many cameras and points an even choice is used.
std::optional<MapScale> EstimateFloorScale(const std::vector<FloorCamera>& cameras,
                                           const std::vector<Eigen::Vector3d>& points_in_map,
                                           const FloorUncertainty& uncertainty);

}  // namespace rovio_sfm
