#include "rovio_sfm/ros/markers.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;

TEST(Markers, SixSessionsHaveColoursOfTheirOwn) {
  for (uint32_t a = 1; a <= 6; ++a) {
    for (uint32_t b = 1; b < a; ++b) EXPECT_NE(SessionColor({a}), SessionColor({b}));
  }
  EXPECT_EQ(SessionColor({7}), SessionColor({1}));
}

TEST(Markers, LineIsAsWideAsItsExtentAsks) {
  Marker line = MakeMarker("map", "path", Marker::LINE_STRIP, Marker::ADD, ros::Time(3));
  line.points.resize(2);
  PaintLine({1.0f, 0.5f, 0.0f}, &line);
  EXPECT_DOUBLE_EQ(line.scale.x, 0.01);  // does not vanish
  line.points[1].y = 10.0;
  PaintLine({1.0f, 0.5f, 0.0f}, &line);
  EXPECT_DOUBLE_EQ(line.scale.x, 0.04);
  EXPECT_EQ(line.color.g, 0.5f);
  EXPECT_EQ(line.color.a, 1.0f);
}

TEST(Markers, ClearingSpeaksOfTheFrameThatIsAlwaysThere) {
  const Marker clear = ClearMarkers(ros::Time(3));
  EXPECT_EQ(clear.action, Marker::DELETEALL);
  EXPECT_EQ(clear.header.frame_id, "map");
}

}  // namespace
}  // namespace rovio_sfm
