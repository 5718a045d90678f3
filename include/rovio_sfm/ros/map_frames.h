#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"

// The tf frames of maps and sessions, and the poses in them; see report/level_session.h.
namespace rovio_sfm {

// "map", in which the root map is shown: the first that has a frame.
std::string MapFrame();
std::string SessionFrame(SessionId session);

// True for an edge that a mapper publishes (MapEdges), now or when a bag was recorded: it hangs
// from, or carries, the frame of a session.
bool IsMapEdge(const geometry_msgs::TransformStamped& edge);

// The message without such edges.
tf2_msgs::TFMessage WithoutMapEdges(const tf2_msgs::TFMessage& message);

// All edges of one picture: map → session_<n>/map for the sessions of the root map, and for each
// robot session_<n>/map → <robot>/odom, where the map is metric and odometry and head are known at
// its newest registered frame, else the leaf session_<n>/map → <robot>/camera_map.
std::vector<geometry_msgs::TransformStamped> MapEdges(const MapPicture& picture,
                                                      const ros::Time& stamp);

}  // namespace rovio_sfm
