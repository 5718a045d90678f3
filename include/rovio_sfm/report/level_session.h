#pragma once

#include <optional>

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/map_snapshot.h"

// Sessions as the world sees them: level, at base_link of the frame that LevelFromSession takes,
// x forward, z up; metres if the map is metric, else units of the map.
namespace rovio_sfm {

// The session that holds the gauge of the root map; null while no session has a frame.
const SessionSnapshot* FindRoot(const MapSnapshot& snapshot);
const SessionSnapshot* FindSession(const MapSnapshot& snapshot, SessionId id);  // null: unknown

// The registered frame with that index; null if it has no pose (any more).
const FrameSnapshot* FindFrame(const SessionSnapshot& session, uint32_t index);

// session_<n>/map from the session's own gauge. All sessions of a map share its unit, so that rigid
// motions join them. Nothing for a session without frames.
std::optional<Sim3> LevelInUnitOfMap(const SessionSnapshot& session);

// level_from_camera: the camera in its session's frame. Nothing for a session without frames.
std::optional<Rigid3> CameraInLevel(const SessionSnapshot& session, const FrameSnapshot& frame);

}  // namespace rovio_sfm
