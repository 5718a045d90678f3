#include "rovio_sfm/ros/markers.h"

#include <algorithm>
#include <vector>

#include "rovio_sfm/ros/map_frames.h"

namespace rovio_sfm {
namespace {

constexpr double kWidthShare = 0.004;  // of a line: of its extent
constexpr double kMinWidth = 0.01;

// The wider side of a line, seen from above.
double ExtentOf(const std::vector<geometry_msgs::Point>& points) {
  if (points.empty()) return 0.0;
  const auto [min_x, max_x] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [min_y, max_y] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return std::max(max_x->x - min_x->x, max_y->y - min_y->y);
}

}  // namespace

std::array<float, 3> SessionColor(SessionId session) {
  constexpr std::array<std::array<float, 3>, 6> kColors = {{{0.12f, 0.47f, 0.71f},
                                                            {1.0f, 0.5f, 0.05f},
                                                            {0.17f, 0.63f, 0.17f},
                                                            {0.84f, 0.15f, 0.16f},
                                                            {0.58f, 0.4f, 0.74f},
                                                            {0.55f, 0.34f, 0.29f}}};
  return kColors[(session.value - 1) % kColors.size()];
}

visualization_msgs::Marker MakeMarker(const std::string& frame, const std::string& name, int type,
                                      int action, const ros::Time& stamp) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.header.stamp = stamp;
  marker.ns = name;
  marker.type = type;
  marker.action = action;
  marker.pose.orientation.w = 1.0;
  marker.color.a = 1.0f;
  return marker;
}

visualization_msgs::Marker ClearMarkers(const ros::Time& stamp) {
  using visualization_msgs::Marker;
  return MakeMarker(MapFrame(), "", Marker::CUBE, Marker::DELETEALL, stamp);
}

void PaintLine(const std::array<float, 3>& color, visualization_msgs::Marker* marker) {
  marker->color.r = color[0];
  marker->color.g = color[1];
  marker->color.b = color[2];
  marker->scale.x = std::max(kWidthShare * ExtentOf(marker->points), kMinWidth);
}

}  // namespace rovio_sfm
