#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/estimate_odometry_delay.h"

namespace rovio_sfm {

// The headings of the wheels at the stamps (ns) of a drive's images, rad.
using YawByStamp = std::map<int64_t, double>;

// How late odometry comes (design 5.2.7), by a session's keyframes. Nothing where the head's pose
// or the odometry is unknown, or the robot turned too little.
std::optional<OdometryDelay> MeasureOdometryDelay(const Session& session);

// Measures it, keeps it in the session, and logs what to do about it.
void UpdateOdometryDelay(Session* session);

// As the first, by every registered frame of a map, light ones too: the most certain of its
// sessions.
std::optional<OdometryDelay> MeasureOdometryDelay(const LevelMap& map,
                                                  const std::map<DriveId, YawByStamp>& yaws);

}  // namespace rovio_sfm
