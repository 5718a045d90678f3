#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>

#include "rovio_sfm/app/camera_topics.h"
#include "rovio_sfm/app/image_gate.h"
#include "rovio_sfm/app/robot_names.h"
#include "rovio_sfm/app/sensor_options.h"
#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The private parameters of frontend_node.
struct FrontendNodeOptions {
  std::string robot;
  std::string calibration_file;
  uint64_t seed = 1;
  double diagnostic_period = 1.0;
  CameraTopicOptions topics;
  GateOptions gate;
  SensorOptions sensors;
  FrontendOptions frontend;

  void DescribeOptions(OptionTable& table) {
    AddRobotName(table, robot, "name in every event; missing: last part of the node's namespace");
    table.AddText(
        "calibration_file", calibration_file,
        "absolute path: calibration.txt, or camera_info as .yaml; instead of camera_info");
    table.AddNumber("seed", seed, 0, kNoLimit, "of everything random in the frontend");
    table.AddNumber("diagnostic_period", diagnostic_period, 0.1, 60.0, "s between two diagnostics");
    table.AddGroup("topics", topics, "where images, camera_info and odometry come from");
    table.AddGroup("gate", gate, "an image waits for its camera_info and odometry");
    table.AddGroup("sensors", sensors, "what a robot says of itself, put together with its images");
    table.AddGroup("frontend", frontend, "config/frontend.yaml");
  }
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit. `name_space` is the node's, for the robot's name.
FrontendNodeOptions LoadFrontendNodeOptions(const YAML::Node& parameters,
                                            const std::string& name_space);

}  // namespace rovio_sfm
