#pragma once

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "rovio_sfm/app/changed_parts.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// The paths of any number of sessions in one message: a line per session through its cameras, in
// its own colour and frame. At first all, then those of sessions that changed; those that have no
// path any more are deleted.
visualization_msgs::MarkerArray PathMarkers(const MapSnapshot& snapshot, const ros::Time& stamp);
visualization_msgs::MarkerArray ChangedPathMarkers(const MapSnapshot& snapshot,
                                                   const SessionChanges& changes,
                                                   const ros::Time& stamp);

}  // namespace rovio_sfm
