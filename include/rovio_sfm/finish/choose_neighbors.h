#pragma once

#include <cstdint>
#include <vector>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

struct NeighborOptions {
  size_t max_neighbors = 40;
  size_t min_common = 15;  // points that both see
  // Of the angle at a point that two pictures see; outside of it they tell little, or look too
  // different.
  double min_angle_rad = 0.015, max_angle_rad = 0.5;
  double best_angle_rad = 0.1;  // 6 deg
};

// What the sweep of an image works with, from the points that it sees.
struct ImageSurroundings {
  double near = 0.0, far = 0.0;  // depths, map units, with some room; 0: it sees too few points
  double typical = 0.0;          // median depth
  // Indices of images, the one that tells most first, then what adds most to those before: together
  // they measure every part of the picture.
  std::vector<uint32_t> neighbors;
};

// By image of the model.
std::vector<ImageSurroundings> ChooseNeighbors(const MapModel& model,
                                               const NeighborOptions& options);

}  // namespace rovio_sfm
