#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

struct GridOptions {
  double resolution_m = 0.05;
  double min_height_m = 0.04, max_height_m = 0.40;  // above the floor: what a Rovio runs into
  double max_range_m = 4.0;                         // of a ray that frees cells
  double max_reach_m = 10.0;     // of points from the cameras: the grid ends there
  double robot_radius_m = 0.15;  // free where it stood
  int min_points = 3;            // in a cell, to be occupied
  double min_free = 3;           // rays through a cell, to be free
  double margin_m = 0.5;         // round all that is known
};

enum class GridCell : int8_t {
  kUnknown = -1,
  kFree = 0,
  kOccupied = 100
};  // as OccupancyGrid has them

// What is free and what is not on the floor of a level map.
struct OccupancyGridMap {
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m =
      Eigen::Vector2d::Zero();  // the outer corner of cell (0, 0): least x, y
  int width = 0, height = 0;    // cells along x and y
  std::vector<GridCell> cells;  // row by row of equal y, from the least y

  GridCell At(int column, int row) const {
    return cells[static_cast<size_t>(row) * static_cast<size_t>(width) +
                 static_cast<size_t>(column)];
  }
};

// A grid of a metric model in its level frame (base at the first image on the floor). Heights are
// over the plane of the points near z = 0 (over z = 0 where those are few). Points in the robot's
// height band occupy cells, rays from cameras to the points that they see free those
// between, and so do the places where the robot stood. Points of a dense cloud, where there is one,
// occupy too. Empty for a model without images. Throws std::invalid_argument where the model is not
// in metres.
OccupancyGridMap MakeGrid(const MapModel& model, const PointCloud* dense,
                          const GridOptions& options);

}  // namespace rovio_sfm
