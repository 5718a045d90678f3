#include "rovio_sfm/ros/product_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include "rovio_sfm/ros/markers.h"

namespace rovio_sfm {
namespace {

using sensor_msgs::PointField;
using visualization_msgs::Marker;

constexpr char kMeshName[] = "mesh";

std_msgs::Header HeaderOf(const std::string& frame_id, const ros::Time& stamp) {
  std_msgs::Header header;
  header.frame_id = frame_id;
  header.stamp = stamp;
  return header;
}

void AddCorner(const DensePoint& corner, Marker* marker) {
  geometry_msgs::Point point;
  point.x = corner.position.x(), point.y = corner.position.y(), point.z = corner.position.z();
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(corner.color[0]) / 255.0f;
  color.g = static_cast<float>(corner.color[1]) / 255.0f;
  color.b = static_cast<float>(corner.color[2]) / 255.0f;
  color.a = 1.0f;
  marker->points.push_back(point);
  marker->colors.push_back(color);
}

}  // namespace

sensor_msgs::PointCloud2 DenseCloudMessage(const PointCloud& cloud, const std::string& frame_id,
                                           const ros::Time& stamp) {
  sensor_msgs::PointCloud2 message;
  message.header = HeaderOf(frame_id, stamp);
  message.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(message);
  modifier.setPointCloud2Fields(8, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "rgb", 1, PointField::FLOAT32, "normal_x", 1,
                                PointField::FLOAT32, "normal_y", 1, PointField::FLOAT32, "normal_z",
                                1, PointField::FLOAT32, "views", 1, PointField::UINT32);
  modifier.resize(cloud.size());
  sensor_msgs::PointCloud2Iterator<float> x(message, "x"), normal(message, "normal_x");
  sensor_msgs::PointCloud2Iterator<uint8_t> bgr(message, "rgb");
  sensor_msgs::PointCloud2Iterator<uint32_t> views(message, "views");
  for (const DensePoint& point : cloud) {
    for (int axis = 0; axis < 3; ++axis) {
      x[axis] = point.position[axis];
      normal[axis] = point.normal[axis];
      bgr[axis] = point.color[static_cast<size_t>(2 - axis)];
    }
    *views = point.num_views;
    ++x, ++normal, ++bgr, ++views;
  }
  return message;
}

Marker MeshMarker(const TriangleMesh& mesh, const std::string& frame_id, const ros::Time& stamp) {
  const int action = mesh.triangles.empty() ? Marker::DELETE : Marker::ADD;
  Marker marker = MakeMarker(frame_id, kMeshName, Marker::TRIANGLE_LIST, action, stamp);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) AddCorner(mesh.vertices[corner], &marker);
  }
  return marker;
}

nav_msgs::OccupancyGrid GridMessage(const OccupancyGridMap& grid, const std::string& frame_id,
                                    const ros::Time& stamp) {
  nav_msgs::OccupancyGrid message;
  message.header = HeaderOf(frame_id, stamp);
  message.info.map_load_time = stamp;
  message.info.resolution = static_cast<float>(grid.resolution_m);
  message.info.width = static_cast<uint32_t>(grid.width);
  message.info.height = static_cast<uint32_t>(grid.height);
  message.info.origin.position.x = grid.origin_m.x();
  message.info.origin.position.y = grid.origin_m.y();
  message.info.origin.orientation.w = 1.0;
  for (const GridCell cell : grid.cells) message.data.push_back(static_cast<int8_t>(cell));
  return message;
}

}  // namespace rovio_sfm
