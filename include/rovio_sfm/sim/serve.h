#pragma once

#include <string>
#include <vector>

#include "rovio_sfm/sim/http/rovio_http_server.h"
#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

struct ServeOptions {
  RovioHttpServerOptions server;
  std::vector<std::string> quirks;  // NAME=VALUE, switched on from the start
};

// Nanoseconds since the Unix epoch that never run back, in real time.
Clock RealTimeClock();

// Serves the robot in real time until SIGINT or SIGTERM, and prints the address once it listens.
// Returns the exit status; 1, with the reason on stderr, when it cannot begin. Call it before any
// other thread is started: the two signals are blocked and waited for.
int ServeRobot(const ServeOptions& options, RobotBackend& robot);

// `rovio_sim --images DIR`: the pictures of a data-set folder in order.
int ServeImages(const ServeOptions& options, const std::string& folder, bool repeats);

}  // namespace rovio_sfm::sim
