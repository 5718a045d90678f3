#pragma once

#include "rovio_sfm/sim/http/parameters.h"
#include "rovio_sfm/sim/http/server_context.h"
#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// nav action 18: drive, head, stop and turns by steps. kParameterMissing without `drive` (or
// without `speed` where it counts), kOutOfRange for values past the table, kBusy with the quirk.
NavResponse RunDriveAction(const Parameters& parameters, ServerContext& context);

// nav action 19: IR=0|1 and LIGHT=0|1, either or both.
NavResponse RunSwitchAction(const Parameters& parameters, ServerContext& context);

}  // namespace rovio_sfm::sim
