#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <optional>
#include <string>

// What mapping publishes, as the JSON that the live page reads (docs/ros_interface.md). Numbers of
// points are base64 of little-endian float32, colours of uint8.
namespace rovio_sfm {

// Positions, colours, sessions and views of at most kMaxPagePoints points, chosen evenly. Nothing
// where the message is malformed; `error` names the field.
std::optional<std::string> LiveCloud(const sensor_msgs::PointCloud2& cloud, std::string* error);

// The points of lines in the frame of their session, 0: that of the map.
std::string LiveLines(const visualization_msgs::Marker& marker);
// All markers of a message in one.
std::string LiveShapes(const visualization_msgs::MarkerArray& markers);

std::string LivePose(const geometry_msgs::Pose& pose);
std::string LivePose(const geometry_msgs::Transform& transform);

// 3 of "session_3/map"; nothing for another frame.
std::optional<uint32_t> SessionOfFrame(const std::string& frame_id);

}  // namespace rovio_sfm
