#include "rovio_sfm/ros/map_frames.h"

#include <gtest/gtest.h>

#include "report/small_map.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/conversions.h"

namespace rovio_sfm {
namespace {

const geometry_msgs::TransformStamped* Find(
    const std::vector<geometry_msgs::TransformStamped>& edges, const std::string& child) {
  for (const auto& edge : edges) {
    if (edge.child_frame_id == child) return &edge;
  }
  return nullptr;
}

// base x forward, z up from the optical axes; the camera 0.2 m above the floor.
Rigid3 LevelHead() {
  Eigen::Matrix3d rotation;
  rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(rotation), {0.0, 0.0, 0.2}};
}

// The session's map is metric with two metres a unit, head and odometry are known.
MapPicture MetricPicture() {
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->sessions = {SmallSession(1)};
  snapshot->sessions[0].scale = MapScale{2.0, 0.01, "odometry"};
  FrameBlock frames = *snapshot->sessions[0].frames[0];
  for (FrameSnapshot& frame : frames) frame.base_from_camera = LevelHead();
  snapshot->sessions[0].frames[0] = std::make_shared<const FrameBlock>(frames);
  MapPicture picture;
  picture.snapshot = snapshot;
  picture.anchors["rovio1"] = {SessionId{1}, 4, OdometrySample{1.0, 0.0, 0.0, {}}};
  return picture;
}

TEST(MapFrames, MetricMapCarriesTheOdometryOfItsRobot) {
  const auto edges = MapEdges(MetricPicture(), ros::Time(5));
  EXPECT_EQ(Find(edges, "rovio1/camera_map"), nullptr);
  const auto* odom = Find(edges, "rovio1/odom");
  ASSERT_NE(odom, nullptr);
  EXPECT_EQ(odom->header.frame_id, "session_1/map");
  EXPECT_EQ(odom->header.stamp, ros::Time(5));
  EXPECT_NEAR(odom->transform.translation.x, 3.0, 1e-9);  // 2 units of 2 m, less 1 m of odometry
  EXPECT_NEAR(odom->transform.translation.z, 0.0, 1e-9);
  EXPECT_NEAR(odom->transform.rotation.w, 1.0, 1e-9);
}

// Frames without odometry keep the edge of one shortly before them in their drive, and no other.
TEST(MapFrames, AFewFramesWithoutOdometryKeepTheWheelsInTheMap) {
  MapPicture picture = MetricPicture();
  const auto has_wheels = [&] {
    return Find(MapEdges(picture, ros::Time(5)), "rovio1/odom") != nullptr;
  };
  picture.anchors["rovio1"].odometry.reset();
  EXPECT_FALSE(has_wheels());
  picture.wheel_anchors["rovio1"] = {SessionId{1}, 2, OdometrySample{1.0, 0.0, 0.0, {}}};
  EXPECT_TRUE(has_wheels());
  picture.wheel_anchors["rovio1"].drive.nonce = 7;
  EXPECT_FALSE(has_wheels());
  for (const uint32_t index : {11u, 10u}) {
    MapPicture gap = MetricPicture();
    auto snapshot = std::make_shared<MapSnapshot>(*gap.snapshot);
    FrameBlock frames = *snapshot->sessions[0].frames[0];
    frames.back().index = frames[0].index + index;
    snapshot->sessions[0].frames[0] = std::make_shared<const FrameBlock>(frames);
    gap.snapshot = snapshot;
    gap.anchors["rovio1"] = {SessionId{1}, frames.back().index, std::nullopt};
    gap.wheel_anchors["rovio1"] = {SessionId{1}, frames[0].index, OdometrySample{}};
    picture = gap;
    EXPECT_EQ(has_wheels(), index <= 10);
  }
}

TEST(MapFrames, WithoutAScaleTheCameraIsALeaf) {
  MapPicture picture = MetricPicture();
  auto snapshot = std::make_shared<MapSnapshot>(*picture.snapshot);
  snapshot->sessions[0].scale.reset();
  picture.snapshot = snapshot;
  const auto edges = MapEdges(picture, ros::Time(5));
  EXPECT_EQ(Find(edges, "rovio1/odom"), nullptr);
  const auto* camera = Find(edges, "rovio1/camera_map");
  ASSERT_NE(camera, nullptr);
  EXPECT_NEAR(camera->transform.translation.x, 2.0, 1e-9);
}

TEST(MapFrames, WithoutOdometryTheCameraIsALeaf) {
  MapPicture picture = MetricPicture();
  picture.anchors["rovio1"].odometry.reset();
  EXPECT_NE(Find(MapEdges(picture, ros::Time(5)), "rovio1/camera_map"), nullptr);
}

TEST(MapFrames, OnlySessionsOfTheRootMapHangBelowMap) {
  MapPicture picture;
  picture.snapshot = SmallMaps(2);
  const auto edges = MapEdges(picture, ros::Time(5));
  const auto* root = Find(edges, "session_1/map");
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root->header.frame_id, "map");
  EXPECT_NEAR(root->transform.rotation.w, 1.0, 1e-12);
  EXPECT_EQ(Find(edges, "session_2/map"), nullptr);
}

TEST(MapFrames, MergedSessionHangsWhereTheMergePutsIt) {
  MapPicture picture;
  auto snapshot = std::make_shared<MapSnapshot>(*SmallMaps(2));
  snapshot->sessions[1].map = {1};
  snapshot->sessions[1].map_from_session.translation = Eigen::Vector3d(0.0, 0.0, 3.0);
  picture.snapshot = snapshot;
  const auto edges = MapEdges(picture, ros::Time(5));
  const auto* merged = Find(edges, "session_2/map");
  ASSERT_NE(merged, nullptr);
  EXPECT_NEAR(merged->transform.translation.x, 3.0, 1e-9);  // along the view: forward
}

TEST(MapFrames, CamerasAreWhereTheCloudOfTheMergedMapHasThem) {
  auto snapshot = std::make_shared<MapSnapshot>(*SmallMaps(2));
  snapshot->sessions[1].map = {1};
  snapshot->sessions[1].map_from_session = {
      2.0,
      Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, 1.0, 0.2).normalized())),
      {1.0, 2.0, 3.0}};
  snapshot->sessions[0].scale = MapScale{0.5, 0.01, "odometry"};
  snapshot->sessions[1].scale = MapScale{1.0, 0.01, "odometry"};
  MapPicture picture;
  picture.snapshot = snapshot;
  const auto edges = MapEdges(picture, ros::Time(5));
  const auto* edge = Find(edges, "session_2/map");
  ASSERT_NE(edge, nullptr);
  std::string error;
  const auto map_from_level = FromTransform(edge->transform, &error);
  ASSERT_TRUE(map_from_level) << error;
  const SessionSnapshot& merged = snapshot->sessions[1];
  const auto level_from_camera = CameraInLevel(merged, *FindFrame(merged, 2));
  const std::vector<PosedImage> images = PosedImages(*FindLevelMap(*snapshot, MapId{1}));
  const Rigid3& expected = images[4].level_from_camera.reference_from_body;
  const Rigid3 map_from_camera = *map_from_level * *level_from_camera;
  EXPECT_LT((map_from_camera.translation - expected.translation).norm(), 1e-9);
  EXPECT_LT(map_from_camera.rotation.angularDistance(expected.rotation), 1e-6);
}

TEST(MapFrames, ItsOwnEdgesAreKnownAndThoseOfARobotAreNot) {
  tf2_msgs::TFMessage message;
  message.transforms = MapEdges(MetricPicture(), ros::Time(5));
  for (const auto& edge : message.transforms) EXPECT_TRUE(IsMapEdge(edge)) << edge;
  geometry_msgs::TransformStamped robot;
  robot.header.frame_id = "rovio1/odom";
  robot.child_frame_id = "rovio1/base_link";
  message.transforms.push_back(robot);
  robot.header.frame_id = "map";
  robot.child_frame_id = "dock";
  message.transforms.push_back(robot);
  EXPECT_EQ(WithoutMapEdges(message).transforms.size(), 2u);
}

TEST(MapFrames, AnchorOfAVanishedFrameGivesNoEdge) {
  MapPicture picture = MetricPicture();
  picture.anchors["rovio1"].index = 3;
  EXPECT_EQ(MapEdges(picture, ros::Time(5)).size(), 1u);
}

}  // namespace
}  // namespace rovio_sfm
