#pragma once

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// Gives a session back its frames and landmarks of before a merge, to the byte. Frames that came
// since keep their place relative to those (by a similarity over common landmarks, or cameras),
// with landmarks of their own, and are resected there.
void RestoreSession(const Session& before, const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
