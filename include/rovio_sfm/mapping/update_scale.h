#pragma once

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// Estimates the session's scale from its keyframes' odometry or, where the options give one, from
// the camera's height over the floor: the more certain of both. A new scale is adopted when there
// was none, when it leaves the old one's 2 sigma, or when `adopt` says so (at the session's end).
// True if the session's scale changed. With `adopt` it also logs how late odometry comes.
bool UpdateScale(const ScaleOptions& options, bool adopt, Session* session);

}  // namespace rovio_sfm
