#include "rovio_sfm/ros/live_status.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rovio_sfm {
namespace {

using Json = nlohmann::json;

SessionSummary Session(uint32_t number, uint32_t map, const std::string& robot, uint32_t frames) {
  SessionSummary session;
  session.session = number;
  session.map = map;
  session.state = SessionSummary::MAPPING;
  session.drive.robot = robot;
  session.num_frames = session.num_keyframes = frames;
  return session;
}

MapSummary Map(uint32_t number, uint32_t frames) {
  MapSummary map;
  map.map = number;
  map.num_frames = frames;
  return map;
}

MapStatus TwoMaps() {
  MapStatus status;
  status.sessions = {Session(1, 1, "rovio1", 0), Session(2, 2, "rovio2", 5),
                     Session(3, 3, "rovio1", 9)};
  status.maps = {Map(1, 0), Map(2, 5), Map(3, 9)};
  return status;
}

TEST(LiveStatus, ShowsTheMapOfTheFirstSessionWithFrames) {
  MapStatus status = TwoMaps();
  EXPECT_EQ(Json::parse(LiveStatus(status))["root"], 2);
  EXPECT_EQ(Json::parse(LiveStatus(status))["figures"]["images"], 5);
  EXPECT_EQ(Json::parse(LiveStatus(status))["figures"]["maps"], 2);
  status.sessions[1].map = 3;  // merged: session 2 joined the map of session 3
  EXPECT_EQ(Json::parse(LiveStatus(status))["root"], 3);
  EXPECT_EQ(Json::parse(LiveStatus(status))["figures"]["keyframes"], 14);
}

TEST(LiveStatus, TellsNothingOfAMapBeforeThereIsOne) {
  const Json json = Json::parse(LiveStatus(MapStatus()));
  EXPECT_EQ(json["root"], 0);
  EXPECT_TRUE(json["figures"].empty());
  EXPECT_TRUE(json["sessions"].empty());
  EXPECT_EQ(json["unit"], "map units");
}

TEST(LiveStatus, ListsSessionsByRobotAndState) {
  MapStatus status = TwoMaps();
  status.sessions[2].state = 200;  // of a newer mapping
  const Json json = Json::parse(LiveStatus(status));
  EXPECT_EQ(json["sessions"][1]["robot"], "rovio2");
  EXPECT_EQ(json["sessions"][1]["state"], "maps");
  EXPECT_EQ(json["sessions"][2]["state"], "unknown");
}

TEST(LiveStatus, TellsMergesWithTheirReasons) {
  MapStatus status = TwoMaps();
  MergeReportMsg merge;
  merge.id = 4;
  merge.verdict = MergeReportMsg::REFUSED;
  merge.reason = "12 inliers, fewer than 25";
  merge.query.drive.robot = "rovio2";
  merge.query.index = 7;
  merge.query_session = 2;
  merge.other_session = 3;
  status.merges = {merge};
  const Json json = Json::parse(LiveStatus(status))["merges"][0];
  EXPECT_EQ(json["verdict"], "refused");
  EXPECT_EQ(json["reason"], "12 inliers, fewer than 25");
  EXPECT_EQ(json["query"], "rovio2/7");
  EXPECT_EQ(json["other"], "by hand");
  EXPECT_EQ(json["sessions"], Json::parse("[2, 3]"));
}

TEST(LiveStatus, WarnsOfWhatIsLost) {
  MapStatus status = TwoMaps();
  status.store_error = "disk full";
  status.num_missing = 3;
  status.why_not_metric = {"rovio1: no odometry"};
  EXPECT_EQ(
      Json::parse(LiveStatus(status))["warnings"],
      Json({"rovio1: no odometry", "Maps are not saved: disk full", "3 frames never arrived"}));
}

TEST(LiveStatus, OddBytesInNamesStayJson) {
  MapStatus status = TwoMaps();
  status.sessions[0].drive.robot = "\xff</script>";
  EXPECT_TRUE(Json::accept(LiveStatus(status)));
}

}  // namespace
}  // namespace rovio_sfm
