#include "rovio_sfm/ros/product_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;

TriangleMesh Triangle() {
  TriangleMesh mesh;
  mesh.vertices = {{{0, 0, 0}, {0, 0, 1}, {255, 0, 0}, 0},
                   {{1, 0, 0}, {0, 0, 1}, {0, 255, 0}, 0},
                   {{0, 1, 0}, {0, 0, 1}, {0, 0, 255}, 0}};
  mesh.triangles = {{{0, 1, 2}}};
  return mesh;
}

TEST(ProductMessages, CloudHoldsPositionColourNormalAndViews) {
  const PointCloud cloud = {{{1, 2, 3}, {0, 0, 1}, {10, 20, 30}, 4},
                            {{5, 6, 7}, {0, -1, 0}, {0, 0, 0}, 2}};
  const auto message = DenseCloudMessage(cloud, "map", ros::Time(3));
  ASSERT_EQ(message.width * message.height, 2u);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.header.stamp, ros::Time(3));
  sensor_msgs::PointCloud2ConstIterator<float> x(message, "x"), normal(message, "normal_x");
  sensor_msgs::PointCloud2ConstIterator<uint8_t> bgr(message, "rgb");
  sensor_msgs::PointCloud2ConstIterator<uint32_t> views(message, "views");
  EXPECT_EQ(x[2], 3.0f);
  EXPECT_EQ(normal[2], 1.0f);
  EXPECT_EQ(bgr[2], 10);
  EXPECT_EQ(bgr[0], 30);
  EXPECT_EQ(*views, 4u);
  ++x, ++normal;
  EXPECT_EQ(x[0], 5.0f);
  EXPECT_EQ(normal[1], -1.0f);
}

TEST(ProductMessages, CloudOfNothingIsEmpty) {
  const auto message = DenseCloudMessage({}, "map", ros::Time(3));
  EXPECT_EQ(message.width * message.height, 0u);
  EXPECT_EQ(message.fields.size(), 8u);
}

TEST(ProductMessages, MeshHasACornerAndAColourForEachOfItsTriangles) {
  const Marker marker = MeshMarker(Triangle(), "session_2/map", ros::Time(3));
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(marker.action, Marker::ADD);
  EXPECT_EQ(marker.header.frame_id, "session_2/map");
  ASSERT_EQ(marker.points.size(), 3u);
  ASSERT_EQ(marker.colors.size(), 3u);
  EXPECT_EQ(marker.points[1].x, 1.0);
  EXPECT_EQ(marker.colors[2].b, 1.0f);
  EXPECT_EQ(marker.scale.x, 1.0);
  EXPECT_EQ(marker.pose.orientation.w, 1.0);
}

TEST(ProductMessages, MeshOfNothingTakesBackWhatWasShown) {
  EXPECT_EQ(MeshMarker(TriangleMesh(), "map", ros::Time(3)).action, Marker::DELETE);
}

TEST(ProductMessages, GridHasItsCellsFromTheLeastY) {
  const OccupancyGridMap grid{0.05, {-1.0, 2.0}, 2, 1, {GridCell::kOccupied, GridCell::kUnknown}};
  const auto message = GridMessage(grid, "map", ros::Time(3));
  EXPECT_FLOAT_EQ(message.info.resolution, 0.05f);
  EXPECT_EQ(message.info.width, 2u);
  EXPECT_EQ(message.info.height, 1u);
  EXPECT_EQ(message.info.origin.position.x, -1.0);
  EXPECT_EQ(message.info.origin.position.y, 2.0);
  EXPECT_EQ(message.data, (std::vector<int8_t>{100, -1}));
}

}  // namespace
}  // namespace rovio_sfm
