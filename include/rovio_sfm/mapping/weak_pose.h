#pragma once

#include <optional>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// The pose of a keyframe that could not be resected, from its relative pose to the keyframe before
// (§3.7.1): the length of the baseline comes from odometry where the session has a scale, else it
// is that of the session's last step. Nothing without a matched pair or a step before.
std::optional<Rigid3> PredictWeakPose(const FrameEvent& event, const Session& session);

// Resects a weak keyframe of the session again: true, and it is weak no more, if that works now.
// False for one that the session does not hold.
bool ResectWeakFrame(uint32_t index, const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
