#pragma once

#include <nav_msgs/Path.h>
#include <rovio_sfm/MapStatus.h>
#include <sensor_msgs/PointCloud2.h>

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/report/level_map.h"

// What mapping shows of a snapshot. Lengths are metres where the map is metric, else map units.
namespace rovio_sfm {

// Fields x y z rgb (float32), session views (uint32), error (float32, px); the landmarks that
// count, in `frame_id`, the level frame of the map.
sensor_msgs::PointCloud2 CloudMessage(const LevelMap& map, const std::string& frame_id,
                                      const ros::Time& stamp);

// The cameras of a session in session_<n>/map, by index; weak poses are left out.
nav_msgs::Path PathMessage(const SessionSnapshot& session, const ros::Time& stamp);

SessionSummary SummaryOf(const SessionSnapshot& session);
// Nothing for a map without a frame.
std::optional<MapSummary> SummaryOf(const MapSnapshot& snapshot, MapId id);
std::vector<SessionSummary> SessionSummaries(const MapSnapshot& snapshot);
std::vector<MapSummary> MapSummaries(const MapSnapshot& snapshot);

}  // namespace rovio_sfm
