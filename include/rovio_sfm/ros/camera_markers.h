#pragma once

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "rovio_sfm/app/changed_parts.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/merge_report.h"

namespace rovio_sfm {

// One list of frusta per session, in its own colour and frame; keyframes only. Then the overlaps,
// as lines between the centres of their two cameras, in the frame of the other session: accepted
// ones, and, in another colour, provisional ones: to where the query would stand if they were true.
visualization_msgs::MarkerArray CameraMarkers(const MapSnapshot& snapshot,
                                              const std::vector<MergeReport>& merges,
                                              const ros::Time& stamp);

// The same of the parts that changed alone; those that show nothing any more are deleted. Together
// with what was sent before they make what CameraMarkers draws.
visualization_msgs::MarkerArray ChangedCameraMarkers(const MapSnapshot& snapshot,
                                                     const std::vector<MergeReport>& merges,
                                                     const SessionChanges& changes,
                                                     const ros::Time& stamp);

}  // namespace rovio_sfm
