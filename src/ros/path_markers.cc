#include "rovio_sfm/ros/path_markers.h"

#include <array>
#include <string>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/markers.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr char kPath[] = "path_";

Marker NoPath(SessionId session, const ros::Time& stamp) {
  return MakeMarker(SessionFrame(session), kPath + std::to_string(session.value),
                    Marker::LINE_STRIP, Marker::DELETE, stamp);
}

std::array<float, 3> Lighter(std::array<float, 3> color) {
  for (float& channel : color) channel = 0.5f + 0.5f * channel;
  return color;
}

// rviz complains of a line of one point.
Marker PathOf(const SessionSnapshot& session, const ros::Time& stamp) {
  Marker marker = NoPath(session.id, stamp);
  for (const auto& pose : PathMessage(session, stamp).poses) {
    marker.points.push_back(pose.pose.position);
  }
  if (marker.points.size() < 2) return NoPath(session.id, stamp);
  marker.action = Marker::ADD;
  PaintLine(Lighter(SessionColor(session.id)), &marker);  // over its frusta
  return marker;
}

}  // namespace

MarkerArray ChangedPathMarkers(const MapSnapshot& snapshot, const SessionChanges& changes,
                               const ros::Time& stamp) {
  MarkerArray markers;
  for (const SessionId id : changes.gone) markers.markers.push_back(NoPath(id, stamp));
  for (const SessionId id : changes.sessions) {
    markers.markers.push_back(PathOf(*FindSession(snapshot, id), stamp));
  }
  return markers;
}

MarkerArray PathMarkers(const MapSnapshot& snapshot, const ros::Time& stamp) {
  MarkerArray markers;
  markers.markers.push_back(ClearMarkers(stamp));
  for (const SessionSnapshot& session : snapshot.sessions) {
    Marker path = PathOf(session, stamp);
    if (path.action == Marker::ADD) markers.markers.push_back(std::move(path));
  }
  return markers;
}

}  // namespace rovio_sfm
