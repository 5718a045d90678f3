#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/sim/serve.h"
#include "rovio_sfm/sim/tour/render_tour.h"

namespace rovio_sfm::sim {

// `rovio_sim --serve`: where the robot stands and how it sees.
struct ServeRobotOptions {
  ServeOptions serve;
  std::string config_folder;
  std::string tour;  // its world, and the first way-point as the start
  uint64_t seed = 1;
  uint64_t light = 0;             // of InLight
  bool has_movers = false;        // those of the tour walk
  double shutter_s = 1.0 / 60.0;  // from the first row's opening to the last row's closing
  RenderOptions render;
  DevelopOptions develop;
  SlipOptions slip;

  bool IsValid(std::string* error) const;
};

// Serves a simulated robot until a signal. Returns the exit status; throws std::runtime_error for
// wrong files.
int ServeSimulatedRobot(const ServeRobotOptions& options);

}  // namespace rovio_sfm::sim
