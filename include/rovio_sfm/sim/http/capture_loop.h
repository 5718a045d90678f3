#pragma once

#include "rovio_sfm/sim/http/server_context.h"

namespace rovio_sfm::sim {

// Takes and publishes one picture now; false when none comes (quirk stall, or the robot has none).
bool CaptureOnce(ServerContext& context);

// One picture at each period of the frame rate, while somebody waits for pictures, until the server
// stops. The body of the one capture thread.
void RunCaptureLoop(ServerContext& context);

}  // namespace rovio_sfm::sim
