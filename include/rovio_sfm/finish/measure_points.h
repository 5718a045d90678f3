#pragma once

#include <cstddef>

#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// Of the points of a model and their views.
struct PointFigures {
  size_t num_points = 0;
  size_t num_projections = 0;
  double rms_n = 0.0;   // Eq. 5.2-5.4: 1000 x, over points with more than three views
  double rms_px = 0.0;  // the same in pixels
};

PointFigures MeasurePoints(const MapModel& model);

}  // namespace rovio_sfm
