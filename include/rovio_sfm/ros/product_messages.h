#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include <string>

#include "rovio_sfm/finish/make_grid.h"
#include "rovio_sfm/scene/point_cloud.h"

// What was made of a map, in `frame_id`, its level frame; metres where the map is metric, else map
// units.
namespace rovio_sfm {

// Fields x y z, rgb, normal_x normal_y normal_z (float32), views (uint32).
sensor_msgs::PointCloud2 DenseCloudMessage(const PointCloud& cloud, const std::string& frame_id,
                                           const ros::Time& stamp);

// A TRIANGLE_LIST with a colour for each corner; DELETE for a mesh without triangles.
visualization_msgs::Marker MeshMarker(const TriangleMesh& mesh, const std::string& frame_id,
                                      const ros::Time& stamp);

nav_msgs::OccupancyGrid GridMessage(const OccupancyGridMap& grid, const std::string& frame_id,
                                    const ros::Time& stamp);

}  // namespace rovio_sfm
