#include "rovio_sfm/ros/map_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

TEST(MapMessages, CloudHoldsPositionColourSessionViewsAndError) {
  const auto map = FindLevelMap(*SmallMaps(1), MapId{1});
  ASSERT_TRUE(map);
  const sensor_msgs::PointCloud2 cloud = CloudMessage(*map, "map", ros::Time(3));
  ASSERT_EQ(cloud.width * cloud.height, 2u);
  EXPECT_EQ(cloud.header.frame_id, "map");
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), error(cloud, "error");
  EXPECT_NEAR(x[0], 5.0f, 1e-5f);  // forward
  EXPECT_NEAR(x[2], 1.0f, 1e-5f);  // up
  EXPECT_FLOAT_EQ(*error, 0.5f);
  sensor_msgs::PointCloud2ConstIterator<uint8_t> bgr(cloud, "rgb");
  EXPECT_EQ(bgr[2], 10);
  EXPECT_EQ(bgr[0], 30);
  sensor_msgs::PointCloud2ConstIterator<uint32_t> views(cloud, "views"), session(cloud, "session");
  EXPECT_EQ(*views, 2u);
  EXPECT_EQ(*session, 1u);
}

TEST(MapMessages, PathRunsForwardInTheFrameOfItsSession) {
  const nav_msgs::Path path = PathMessage(SmallSession(2), ros::Time(3));
  EXPECT_EQ(path.header.frame_id, "session_2/map");
  ASSERT_EQ(path.poses.size(), 3u);
  EXPECT_NEAR(path.poses[2].pose.position.x, 2.0, 1e-9);
  EXPECT_NEAR(path.poses[2].pose.position.z, 0.0, 1e-9);
  EXPECT_EQ(path.poses[2].header.stamp, ros::Time(3));
}

TEST(MapMessages, CloudOfAMergedMapHoldsAllItsSessionsInOneScale) {
  MapSnapshot snapshot = *SmallMaps(2);
  snapshot.sessions[1].map = {1};
  snapshot.sessions[1].map_from_session.scale = 2.0;
  snapshot.sessions[0].scale = MapScale{0.5, 0.01, "odometry"};
  snapshot.sessions[1].scale = MapScale{1.0, 0.01, "odometry"};  // of a unit of the session
  const auto map = FindLevelMap(snapshot, MapId{1});
  ASSERT_TRUE(map);
  const sensor_msgs::PointCloud2 cloud = CloudMessage(*map, "map", ros::Time(3));
  ASSERT_EQ(cloud.width * cloud.height, 4u);
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<uint32_t> session(cloud, "session");
  EXPECT_NEAR(x[0], 2.5f, 1e-5f);
  EXPECT_EQ(*session, 1u);
  x += 2, session += 2;
  EXPECT_NEAR(x[0], 5.0f, 1e-5f);
  EXPECT_EQ(*session, 2u);
}

TEST(MapMessages, SummariesCountFramesAndLandmarks) {
  const auto snapshot = SmallMaps(2);
  const auto sessions = SessionSummaries(*snapshot);
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[1].num_keyframes, 3u);
  EXPECT_EQ(sessions[1].last_index, 4u);
  EXPECT_EQ(sessions[1].state, SessionSummary::MAPPING);
  const auto maps = MapSummaries(*snapshot);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(maps[0].num_landmarks, 2u);
  EXPECT_EQ(maps[0].num_observations, 5u);
  EXPECT_FALSE(maps[0].metric);
  EXPECT_EQ(maps[0].metres_per_unit, 0.0);
}

TEST(MapMessages, SummarySaysTheOdometrysDelayWhereItIsKnown) {
  SessionSnapshot session = SmallSession(1);
  EXPECT_FALSE(SummaryOf(session).has_odometry_delay);
  session.odometry_delay = OdometryDelay{0.08, 0.01};
  EXPECT_TRUE(SummaryOf(session).has_odometry_delay);
  EXPECT_EQ(SummaryOf(session).odometry_delay_s, 0.08);
  EXPECT_EQ(SummaryOf(session).odometry_delay_sigma_s, 0.01);
}

TEST(MapMessages, EmptySnapshotGivesEmptyMessages) {
  const MapSnapshot snapshot;
  EXPECT_TRUE(MapSummaries(snapshot).empty());
  EXPECT_TRUE(SessionSummaries(snapshot).empty());
}

}  // namespace
}  // namespace rovio_sfm
