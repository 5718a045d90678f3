#include "rovio_sfm/ros/path_markers.h"

#include <gtest/gtest.h>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;

TEST(PathMarkers, DrawTheLineOfEverySessionInItsColourAndFrame) {
  const auto markers = PathMarkers(*SmallMaps(7), ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 8u);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(markers[7].ns, "path_7");
  EXPECT_EQ(markers[7].header.frame_id, "session_7/map");
  ASSERT_EQ(markers[7].points.size(), 3u);
  EXPECT_NEAR(markers[7].points[2].x, 2.0, 1e-9);
  EXPECT_NE(markers[1].color.r, markers[2].color.r);
}

TEST(PathMarkers, ChangesHoldTheChangedSessionsAndDeleteThoseThatAreGone) {
  SessionChanges changes;
  changes.sessions = {{2}};
  changes.gone = {{3}};
  const auto markers = ChangedPathMarkers(*SmallMaps(2), changes, ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 2u);
  EXPECT_EQ(markers[0].ns, "path_3");
  EXPECT_EQ(markers[0].action, Marker::DELETE);
  EXPECT_EQ(markers[1].ns, "path_2");
  EXPECT_EQ(markers[1].action, Marker::ADD);
}

TEST(PathMarkers, LeaveOutASessionWithoutALine) {
  MapSnapshot snapshot = *SmallMaps(1);
  snapshot.sessions[0].frames.clear();
  EXPECT_EQ(PathMarkers(snapshot, ros::Time(3)).markers.size(), 1u);
}

}  // namespace
}  // namespace rovio_sfm
