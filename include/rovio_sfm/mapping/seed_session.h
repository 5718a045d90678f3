#pragma once

#include <deque>
#include <vector>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session_table.h"

namespace rovio_sfm {

// Starts a session that cannot start by itself from the map that its held frames see (§4.3.2): the
// frames with place matches are resected among the other session's landmarks (2D-3D), their tracks
// carry these landmarks on to the frames around, and landmarks of its own are triangulated between
// the frames so posed. Its gauge is that of the other session; whether the two are one map is for
// the evidence to say, as with any overlap. False, with the session as empty as before, where fewer
// than two frames or too few landmarks come out.
bool SeedSession(const std::deque<FrameEvent>& held, const std::vector<PlaceMatch>& matches,
                 const SessionTable& sessions, const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
