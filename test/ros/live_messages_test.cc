#include "rovio_sfm/ros/live_messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/small_map.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/util/base64.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::json;
using visualization_msgs::Marker;

sensor_msgs::PointCloud2 Cloud() {
  return CloudMessage(*FindLevelMap(*SmallMaps(1), MapId{1}), "map", ros::Time(3));
}

std::string ErrorOf(const sensor_msgs::PointCloud2& cloud) {
  std::string error;
  return LiveCloud(cloud, &error) ? "none" : error;
}

TEST(LiveCloud, HoldsWhatMappingPublishes) {
  std::string error;
  const auto text = LiveCloud(Cloud(), &error);
  ASSERT_TRUE(text) << error;
  const Json json = Json::parse(*text);
  EXPECT_EQ(json["count"], 2);
  EXPECT_EQ(json["total"], 2);
  EXPECT_EQ(json["sessions"], Base64({0, 0}));  // colours count from 0
  EXPECT_EQ(json["views"], Base64({2, 3}));
  EXPECT_EQ(json["colors"].get<std::string>().substr(0, 4), Base64({10, 20, 30}));
  EXPECT_EQ(json["positions"].get<std::string>().size(), 32u);
}

TEST(LiveCloud, AnEmptyCloudIsOne) {
  std::string error;
  const auto text = LiveCloud(CloudMessage(LevelMap(), "map", ros::Time(3)), &error);
  ASSERT_TRUE(text) << error;
  EXPECT_EQ(Json::parse(*text)["count"], 0);
}

TEST(LiveCloud, RefusesMalformedMessages) {
  EXPECT_EQ(ErrorOf(sensor_msgs::PointCloud2()), "cloud field x: expected one float32");
  sensor_msgs::PointCloud2 cloud = Cloud();
  cloud.fields[4].datatype = sensor_msgs::PointField::FLOAT64;
  EXPECT_EQ(ErrorOf(cloud), "cloud field session: expected one uint32");
  cloud = Cloud();
  cloud.fields[5].offset = cloud.point_step - 2;
  EXPECT_EQ(ErrorOf(cloud), "cloud field views: expected one uint32");
  const std::string gaps = "cloud data: expected little-endian width * height points without gaps";
  cloud = Cloud();
  cloud.data.pop_back();
  EXPECT_EQ(ErrorOf(cloud), gaps);
  cloud = Cloud();
  cloud.width = 1u << 31;
  EXPECT_EQ(ErrorOf(cloud), gaps);
  cloud = Cloud();
  cloud.is_bigendian = true;
  EXPECT_EQ(ErrorOf(cloud), gaps);
}

Marker Line() {
  Marker marker;
  marker.type = Marker::LINE_LIST;
  marker.header.frame_id = "session_3/map";
  marker.color.r = 1.0f;
  marker.points.resize(2);
  marker.points[1].x = 1.0;
  return marker;
}

TEST(LiveLines, KeepPointsColourAndSession) {
  const Json json = Json::parse(LiveLines(Line()));
  EXPECT_EQ(json["type"], 5);
  EXPECT_EQ(json["session"], 3);
  EXPECT_EQ(json["color"], Json::parse("[255, 0, 0]"));
  EXPECT_EQ(json["positions"], Base64Of(std::vector<float>{0, 0, 0, 1, 0, 0}));
}

TEST(LiveShapes, AreTheMarkersThatAreDrawn) {
  visualization_msgs::MarkerArray markers;
  Marker clear = Line(), text = Line();
  clear.action = Marker::DELETEALL;
  text.type = Marker::TEXT_VIEW_FACING;
  text.text = "map 2, apart: rovio2";
  text.pose.position.y = 2.5;
  text.scale.z = 0.5;
  markers.markers = {clear, Line(), text};
  const Json json = Json::parse(LiveShapes(markers));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[1]["text"], "map 2, apart: rovio2");
  EXPECT_EQ(json[1]["at"], Json::parse("[0.0, 2.5, 0.0]"));
  EXPECT_EQ(json[1]["height"], 0.5);
}

TEST(LivePose, IsPositionThenQuaternion) {
  geometry_msgs::Transform transform;
  transform.translation.x = 1.5;
  transform.rotation.w = 1.0;
  EXPECT_EQ(LivePose(transform), "[1.5,0.0,0.0,0.0,0.0,0.0,1.0]");
}

TEST(SessionOfFrame, KnowsTheFramesOfSessionsAlone) {
  EXPECT_EQ(SessionOfFrame("session_12/map"), 12u);
  for (const char* frame : {"map", "session_/map", "session_0/map", "session_012/map", "session_1",
                            "session_1/map/x", "session_99999999999/map", "rovio1/odom", ""}) {
    EXPECT_FALSE(SessionOfFrame(frame)) << frame;
  }
}

}  // namespace
}  // namespace rovio_sfm
