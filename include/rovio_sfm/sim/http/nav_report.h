#pragma once

#include <string>

#include "rovio_sfm/sim/http/accounts.h"
#include "rovio_sfm/sim/http/robot_settings.h"
#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// All that the reports of the robot show at one instant.
struct RobotSnapshot {
  NavReading nav;
  McuReading mcu;
  RobotSettings settings;
  Privilege caller_privilege = Privilege::kAdmin;
  bool is_checking_users = false;
  int wifi_signal_strength = 212;  // 0 … 254
  // The picture counter and the size of the last picture, for GetStatus.
  unsigned picture_index = 999999;  // 999999: none yet
  unsigned picture_bytes = 0;
};

// What follows "responses = " in the reply to nav action 1: several lines, no final line end.
std::string FormatNavReport(const RobotSnapshot& snapshot);

}  // namespace rovio_sfm::sim
