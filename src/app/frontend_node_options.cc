#include "rovio_sfm/app/frontend_node_options.h"

#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {
namespace {

void ReadGate(OptionReader reader, GateOptions* options) {
  reader.Read("max_wait_s", &options->max_wait_s);
  reader.Read("startup_wait_s", &options->startup_wait_s);
  reader.RefuseUnknown();
}

std::string LastPart(const std::string& name_space) {
  return name_space.substr(name_space.find_last_of('/') + 1);
}

}  // namespace

bool FrontendNodeOptions::IsValid(std::string* error) const {
  OptionChecker checker("frontend_node", error);
  checker.Range("diagnostic_period", diagnostic_period, 0.1, 60.0);
  checker.Nested(gate);
  checker.Nested(sensors);
  checker.Nested(frontend);
  return checker.Passed() && IsValidRobotName(robot, error);
}

FrontendNodeOptions LoadFrontendNodeOptions(const YAML::Node& parameters,
                                            const std::string& name_space) {
  FrontendNodeOptions options;
  OptionReader reader(parameters, "");
  options.robot = LastPart(name_space);
  reader.Read("robot", &options.robot);
  reader.Read("compressed", &options.compressed);
  reader.Read("seed", &options.seed);
  reader.Read("diagnostic_period", &options.diagnostic_period);
  ReadGate(reader.Group("gate"), &options.gate);
  OptionReader sensors = reader.Group("sensors");
  ReadOptions(&sensors, &options.sensors);
  OptionReader frontend = reader.Group("frontend");
  ReadOptions(&frontend, &options.frontend);
  reader.Group("thresholds");  // what dynamic_reconfigure left there; stands again in "frontend"
  reader.RefuseUnknown();
  RequireValid(options);
  if (options.sensors.base_frame.empty()) options.sensors.base_frame = options.robot + "/base_link";
  for (const std::string& line : reader.Effective()) LogInfo("option " + line);
  return options;
}

}  // namespace rovio_sfm
