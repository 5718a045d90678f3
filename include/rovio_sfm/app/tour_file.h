#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/rovio/tour_plan.h"

namespace rovio_sfm {

// The way-points of a tour's YAML file (x_m, y_m, yaw_deg, frames, arc_center_m). What else stands
// there belongs to the simulator and is left alone. Throws std::runtime_error that names file and
// field.
std::vector<TourWayPoint> LoadTourWayPoints(const std::string& path);

// The same from text; source stands in the messages.
std::vector<TourWayPoint> ParseTourWayPoints(const std::string& yaml, const std::string& source);

}  // namespace rovio_sfm
