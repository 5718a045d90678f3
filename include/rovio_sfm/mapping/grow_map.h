#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/mapping/mapper_report.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session_table.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// What a keyframe that was just posed brings to its session: observations of landmarks that are
// there, new landmarks, a local adjustment (§3.7.2, §3.8.2). The times may be null.
MapGrowth GrowMap(uint32_t frame, const MapperOptions& options, const FrameStore& store,
                  StageTimes* times, Session* session);

using SiblingsOf = std::function<std::vector<Sibling>(const Session&)>;

// Puts a frame that no session holds into the session of its drive of which it shows most: a
// keyframe by the landmarks of its tracks and by those that the matched frames of the place
// observe, resected among them (§3.7.1); a light frame by its tracks alone. The session's siblings
// lend what only they know. Null, and the sessions as they were, where no session poses it by
// options.resect.min_inliers.
Session* RejoinFrame(const FrameEvent& event, const PlaceMatch& place, const MapperOptions& options,
                     const FrameStore& store, StageTimes* times, const SiblingsOf& siblings_of,
                     SessionTable* sessions);

}  // namespace rovio_sfm
