#pragma once

#include <deque>

#include "rovio_sfm/mapping/bootstrap.h"
#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// Makes a map of two frames: both poses (the first camera is the gauge, their distance the unit),
// landmarks, two-view adjustment, cheirality and error again (§3.8.2). False, with the session as
// empty as before, where too few landmarks are left.
bool StartSession(const BootstrapPair& pair, const std::deque<FrameEvent>& held,
                  const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
