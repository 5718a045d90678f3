#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>

#include "rovio_sfm/app/image_gate.h"
#include "rovio_sfm/app/sensor_options.h"
#include "rovio_sfm/frontend/frontend_options.h"

namespace rovio_sfm {

// The private parameters of frontend_node.
struct FrontendNodeOptions {
  std::string robot;       // name in every event; empty: the last part of the node's namespace
  bool compressed = true;  // subscribe image_raw/compressed; else image_raw
  uint64_t seed = 1;       // of everything random in the frontend
  double diagnostic_period = 1.0;  // s between two diagnostics
  GateOptions gate;                // group "gate"
  SensorOptions sensors;           // group "sensors"
  FrontendOptions frontend;        // group "frontend": config/frontend.yaml

  bool IsValid(std::string* error) const;
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit. `name_space` is the node's, for the robot's name.
FrontendNodeOptions LoadFrontendNodeOptions(const YAML::Node& parameters,
                                            const std::string& name_space);

}  // namespace rovio_sfm
