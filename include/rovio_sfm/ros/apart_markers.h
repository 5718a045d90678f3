#pragma once

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// The maps that have not joined the root map, side by side to the right of it in its frame: points,
// paths and what each is called. Where they lie says nothing; a map's own unit is kept. Everything
// drawn before is cleared.
visualization_msgs::MarkerArray ApartMarkers(const MapSnapshot& snapshot, const ros::Time& stamp);

}  // namespace rovio_sfm
