#pragma once

#include <string>

#include "rovio_sfm/sim/http/nav_report.h"

namespace rovio_sfm::sim {

// The 96 characters of GetStatus.cgi and of the stream's status parts.
std::string FormatStatus(const RobotSnapshot& snapshot);

}  // namespace rovio_sfm::sim
