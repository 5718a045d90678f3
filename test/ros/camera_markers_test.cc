#include "rovio_sfm/ros/camera_markers.h"

#include <gtest/gtest.h>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

// Frame 2 of session 2 was recognised as frame 0 of session 1; their gauges differ by 10 units.
MergeReport Overlap(MergeVerdict verdict) {
  MergeReport report;
  report.verdict = verdict;
  report.other_session = {1};
  report.query_session = {2};
  report.other = {SmallSession(1).drive, 0};
  report.query = {SmallSession(2).drive, 2};
  report.query_from_other.translation = Eigen::Vector3d(0.0, 0.0, -10.0);
  return report;
}

TEST(CameraMarkers, DrawEveryKeyframeInTheColourOfItsSession) {
  const auto markers = CameraMarkers(*SmallMaps(2), {}, ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 3u);  // the first clears
  EXPECT_EQ(markers[1].points.size(), 3u * 16u);
  EXPECT_EQ(markers[2].header.frame_id, "session_2/map");
  EXPECT_NE(markers[1].color.r, markers[2].color.r);
}

TEST(CameraMarkers, DrawAnAcceptedOverlapWhereTheMapHasItsCameras) {
  MapSnapshot snapshot = *SmallMaps(2);
  snapshot.sessions[1].map = {1};
  snapshot.sessions[1].map_from_session.translation = Eigen::Vector3d(0.0, 0.0, 4.0);
  const auto markers =
      CameraMarkers(snapshot, {Overlap(MergeVerdict::kAccepted)}, ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 4u);
  EXPECT_EQ(markers[3].header.frame_id, "session_1/map");
  ASSERT_EQ(markers[3].points.size(), 2u);
  EXPECT_NEAR(markers[3].points[0].x, 0.0, 1e-9);
  EXPECT_NEAR(markers[3].points[1].x, 5.0, 1e-9);  // forward: 4 units, and one of the frame
}

TEST(CameraMarkers, DrawAProvisionalOverlapAsItWouldBe) {
  const auto markers =
      CameraMarkers(*SmallMaps(2),
                    {Overlap(MergeVerdict::kProvisional), Overlap(MergeVerdict::kProvisional)},
                    ros::Time(3))
          .markers;
  ASSERT_EQ(markers.size(), 4u);
  ASSERT_EQ(markers[3].points.size(), 4u);
  EXPECT_NEAR(markers[3].points[1].x, 11.0, 1e-9);
}

TEST(CameraMarkers, LeaveOutOverlapsThatAreRefusedOrHaveNoPose) {
  MergeReport vanished = Overlap(MergeVerdict::kAccepted);
  vanished.query.index = 3;
  MergeReport by_hand;
  by_hand.verdict = MergeVerdict::kAccepted;
  by_hand.other_session = {1};
  by_hand.query_session = {2};
  const auto markers =
      CameraMarkers(*SmallMaps(2), {Overlap(MergeVerdict::kRefused), vanished, by_hand},
                    ros::Time(3))
          .markers;
  EXPECT_EQ(markers.size(), 3u);
}

TEST(CameraMarkers, EmptySnapshotOnlyClears) {
  EXPECT_EQ(CameraMarkers(MapSnapshot(), {}, ros::Time(3)).markers.size(), 1u);
}

TEST(CameraMarkers, ChangesHoldTheChangedSessionAlone) {
  SessionChanges changes;
  changes.sessions = {{2}};
  const auto markers = ChangedCameraMarkers(*SmallMaps(2), {}, changes, ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_EQ(markers[0].ns, "session_2");
  EXPECT_EQ(markers[0].action, visualization_msgs::Marker::ADD);
}

TEST(CameraMarkers, ChangesDeleteWhatIsGone) {
  SessionChanges changes;
  changes.gone = {{3}};
  changes.overlaps = {{1}, {3}};
  const auto markers =
      ChangedCameraMarkers(*SmallMaps(2), {Overlap(MergeVerdict::kUndone)}, changes, ros::Time(3))
          .markers;
  ASSERT_EQ(markers.size(), 5u);
  EXPECT_EQ(markers[0].ns, "session_3");
  EXPECT_EQ(markers[1].ns, "overlaps_1");
  EXPECT_EQ(markers[2].ns, "provisional_overlaps_1");
  EXPECT_EQ(markers[3].ns, "overlaps_3");
  for (const auto& marker : markers) {
    EXPECT_EQ(marker.action, visualization_msgs::Marker::DELETE) << marker.ns;
  }
}

}  // namespace
}  // namespace rovio_sfm
