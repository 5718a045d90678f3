#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/world/mover.h"

namespace rovio_sfm::sim {

// Where the robot shall go next. Between two way-points it moves evenly, along a line or around
// arc_center_m, and turns evenly.
struct WayPoint {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;   // world; yaw is not wrapped: it tells the turns
  int frames = 1;                               // pictures taken on the way here, this one included
  std::optional<Eigen::Vector2d> arc_center_m;  // the robot's heading turns with the arc
};

// What a tour's YAML file says. The first way-point is the first picture.
struct TourSpec {
  std::string name;
  std::string world;            // name of the world's file without .yaml
  double head_position = 65.0;  // as GetMCUReport tells it
  double interval_s = 2.0;      // between two pictures
  double step_spread = 0.12;    // pictures are taken off their even places by this share of a step
  double exposure = 1.0;        // gain on the world's light
  double exposure_stops = 1.7;  // range by which the light changes over the tour
  std::vector<WayPoint> way_points;
  std::vector<MoverSpec> movers;         // who walks there, if it is wanted
  std::vector<std::string> shares_with;  // tours of the same world whose overlaps are written too

  bool IsValid(std::string* error) const;
};

// Throws std::runtime_error that names the file, the key and what was expected.
TourSpec LoadTour(const std::string& path);

// The same from text; source stands in the messages.
TourSpec ParseTour(const std::string& yaml, const std::string& source);

// The same way with fewer pictures, so that steps are about `times` as long; times > 0.
TourSpec WithLongerSteps(TourSpec tour, double times);

// The movers of a tour; throws std::runtime_error where it names none, or one cannot be read.
Movers LoadMovers(const TourSpec& tour, const std::string& config_folder);

// One pose per picture, jittered along the way and sideways by the seed.
std::vector<PlanarPose> PlanTour(const TourSpec& tour, uint64_t seed);

}  // namespace rovio_sfm::sim
