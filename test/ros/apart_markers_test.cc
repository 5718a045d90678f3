#include "rovio_sfm/ros/apart_markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;

std::vector<Marker> OfKind(const MapSnapshot& snapshot, int kind) {
  std::vector<Marker> found;
  for (const Marker& marker : ApartMarkers(snapshot, ros::Time(3)).markers) {
    if (marker.action == Marker::ADD && marker.type == kind) found.push_back(marker);
  }
  return found;
}

TEST(ApartMarkers, DrawEveryMapButTheRoot) {
  const auto points = OfKind(*SmallMaps(3), Marker::POINTS);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].header.frame_id, "map");
  EXPECT_EQ(points[0].points.size(), 2u);
  EXPECT_EQ(points[0].colors.size(), 2u);
  EXPECT_EQ(OfKind(*SmallMaps(3), Marker::LINE_STRIP).size(), 2u);
}

TEST(ApartMarkers, SayWhatEachMapIs) {
  const auto names = OfKind(*SmallMaps(2), Marker::TEXT_VIEW_FACING);
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(names[0].text, "map 2, apart: rovio2 (map units)");
}

TEST(ApartMarkers, LieSideBySideWithoutOverlap) {
  MapSnapshot snapshot = *SmallMaps(3);
  for (SessionSnapshot& session : snapshot.sessions) {  // two units wide: left is -x of the camera
    LandmarkBlock landmarks = *session.landmarks[0];
    landmarks[0].position.x() = -1.0;
    landmarks[1].position.x() = 1.0;
    session.landmarks = {std::make_shared<const LandmarkBlock>(landmarks)};
  }
  const auto points = OfKind(snapshot, Marker::POINTS);
  ASSERT_EQ(points.size(), 2u);
  const auto [low, high] =
      std::minmax_element(points[0].points.begin(), points[0].points.end(),
                          [](const auto& a, const auto& b) { return a.y < b.y; });
  EXPECT_LT(high->y, -1.0);  // right of the root map
  for (const auto& point : points[1].points) EXPECT_LT(point.y, low->y);
}

TEST(ApartMarkers, OnlyClearWhereAllMapsAreOne) {
  MapSnapshot snapshot = *SmallMaps(2);
  snapshot.sessions[1].map = {1};
  const auto markers = ApartMarkers(snapshot, ros::Time(3)).markers;
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
}

TEST(ApartMarkers, OfNothingOnlyClear) {
  EXPECT_EQ(ApartMarkers(MapSnapshot(), ros::Time(3)).markers.size(), 1u);
}

}  // namespace
}  // namespace rovio_sfm
