#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/ros/mapping_engine.h"

// The tf frames of maps and sessions, and the poses in them. `session_<n>/map` is base_link at the
// session's first registered frame, x forward, z up; metres if the map is metric, else units of the
// map.
namespace rovio_sfm {

// "map", in which the root map is shown: the first that has a frame.
std::string MapFrame();
std::string SessionFrame(SessionId session);

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

// All edges of one picture: map → session_<n>/map for the sessions of the root map, and for each
// robot session_<n>/map → <robot>/odom, where the map is metric and odometry and head are known at
// its newest registered frame, else the leaf session_<n>/map → <robot>/camera_map.
std::vector<geometry_msgs::TransformStamped> MapEdges(const MapPicture& picture,
                                                      const ros::Time& stamp);

}  // namespace rovio_sfm
