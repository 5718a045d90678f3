#pragma once

#include <ros/time.h>
#include <visualization_msgs/Marker.h>

#include <array>
#include <string>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// Red, green and blue from 0 to 1, by which a session is told from others in all that is shown;
// again from the start when there are more.
std::array<float, 3> SessionColor(SessionId session);

// An opaque marker of a frame, at its origin.
visualization_msgs::Marker MakeMarker(const std::string& frame, const std::string& name, int type,
                                      int action, const ros::Time& stamp);

// Clears whatever the listener drew before; comes first in a message that says all.
visualization_msgs::Marker ClearMarkers(const ros::Time& stamp);

// Colour, and a width that neither vanishes nor hides, for the line through the marker's points.
void PaintLine(const std::array<float, 3>& color, visualization_msgs::Marker* marker);

}  // namespace rovio_sfm
