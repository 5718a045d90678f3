#include "rovio_sfm/sim/serve_simulated_robot.h"

#include <stdexcept>

#include "rovio_sfm/sim/robot/simulated_robot.h"
#include "rovio_sfm/sim/tour/tour.h"
#include "rovio_sfm/sim/world/load_world.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

SimulatedRobotOptions RobotOptionsOf(const ServeRobotOptions& options, const TourSpec& tour) {
  const WayPoint& start = tour.way_points.front();
  SimulatedRobotOptions robot;
  robot.start = {start.x_m, start.y_m, start.yaw_rad};
  robot.head_position = tour.head_position;
  robot.exposure = tour.exposure;
  robot.exposure_stops = tour.exposure_stops;
  robot.seed = options.seed;
  robot.shutter_s = options.shutter_s;
  robot.render = options.render;
  robot.develop = options.develop;
  robot.drive.slip = options.slip;
  if (options.has_movers) robot.movers = LoadMovers(tour, options.config_folder);
  return robot;
}

}  // namespace

bool ServeRobotOptions::IsValid(std::string* error) const {
  OptionChecker check("serve", error);
  check.True("tour", !tour.empty() && tour.find('/') == std::string::npos, "the name of a tour");
  check.Nested(render);
  check.Nested(develop);
  check.Nested(slip);
  return check.Passed();
}

int ServeSimulatedRobot(const ServeRobotOptions& options) {
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error(error);
  const TourSpec tour = LoadTour(options.config_folder + "/tours/" + options.tour + ".yaml");
  const World world(
      InLight(LoadWorld(options.config_folder + "/worlds/" + tour.world + ".yaml"), options.light));
  SimulatedRobot robot(world, RobotOptionsOf(options, tour));
  return ServeRobot(options.serve, robot);
}

}  // namespace rovio_sfm::sim
