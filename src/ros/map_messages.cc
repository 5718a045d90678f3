#include "rovio_sfm/ros/map_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <set>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/report/map_statistics.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"

namespace rovio_sfm {
namespace {

using sensor_msgs::PointField;

// Calls visit for every frame with a pose of its own.
template <typename Visit>
void ForEachRegistered(const SessionSnapshot& session, const Visit& visit) {
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      if (!frame.weak) visit(frame);
    }
  }
}

MapSummary SummaryOf(const LevelMap& map) {
  MapSummary summary;
  summary.map = map.id.value;
  for (const SessionSnapshot& session : map.sessions) {
    summary.sessions.push_back(session.id.value);
    summary.revision = std::max(summary.revision, session.gauge_revision);
  }
  summary.metric = map.scale.has_value();
  if (map.scale) {
    summary.scale_source = map.scale->source;
    summary.metres_per_unit = map.scale->metres_per_unit;
    summary.scale_sigma_log = map.scale->sigma_log;
  }
  const MapStatistics statistics = ComputeMapStatistics(map);
  summary.num_frames = static_cast<uint32_t>(statistics.registered);
  summary.num_landmarks =
      static_cast<uint32_t>(statistics.landmarks + statistics.landmarks_two_views);
  summary.num_observations = static_cast<uint32_t>(statistics.projections);
  summary.mean_error_px = statistics.mean_error_px;
  return summary;
}

}  // namespace

sensor_msgs::PointCloud2 CloudMessage(const LevelMap& map, const std::string& frame_id,
                                      const ros::Time& stamp) {
  const std::vector<CloudPoint> points = LevelCloud(map);
  sensor_msgs::PointCloud2 message;
  message.header.frame_id = frame_id;
  message.header.stamp = stamp;
  message.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(message);
  modifier.setPointCloud2Fields(7, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "rgb", 1, PointField::FLOAT32, "session", 1,
                                PointField::UINT32, "views", 1, PointField::UINT32, "error", 1,
                                PointField::FLOAT32);
  modifier.resize(points.size());
  sensor_msgs::PointCloud2Iterator<float> x(message, "x"), error(message, "error");
  sensor_msgs::PointCloud2Iterator<uint8_t> bgr(message, "rgb");
  sensor_msgs::PointCloud2Iterator<uint32_t> session(message, "session"), views(message, "views");
  for (const CloudPoint& point : points) {
    for (int axis = 0; axis < 3; ++axis) x[axis] = static_cast<float>(point.x_in_map[axis]);
    for (int i = 0; i < 3; ++i) bgr[i] = point.color[static_cast<size_t>(2 - i)];
    *session = point.session;
    *views = point.num_views;
    *error = point.error_px;
    ++x, ++error, ++bgr, ++session, ++views;
  }
  return message;
}

nav_msgs::Path PathMessage(const SessionSnapshot& session, const ros::Time& stamp) {
  nav_msgs::Path path;
  path.header.frame_id = SessionFrame(session.id);
  path.header.stamp = stamp;
  ForEachRegistered(session, [&](const FrameSnapshot& frame) {
    const std::optional<Rigid3> level_from_camera = CameraInLevel(session, frame);
    if (!level_from_camera) return;
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = path.header.frame_id;
    pose.header.stamp = ToTime(frame.stamp_ns);
    pose.pose = ToPose(*level_from_camera);
    path.poses.push_back(pose);
  });
  return path;
}

SessionSummary SummaryOf(const SessionSnapshot& session) {
  SessionSummary summary;
  summary.session = session.id.value;
  summary.map = session.map.value;
  summary.state = static_cast<uint8_t>(session.state);
  summary.drive = ToMessage(session.drive);
  summary.has_odometry_delay = session.odometry_delay.has_value();
  if (session.odometry_delay) {
    summary.odometry_delay_s = session.odometry_delay->delay_s;
    summary.odometry_delay_sigma_s = session.odometry_delay->sigma_s;
  }
  bool is_first = true;
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      if (is_first) summary.first_index = frame.index;
      is_first = false;
      summary.last_index = frame.index;
      if (frame.weak) {
        ++summary.num_weak_frames;
        continue;
      }
      ++summary.num_frames;
      ++(frame.kind == FrameKind::kKeyframe ? summary.num_keyframes : summary.num_light_frames);
    }
  }
  return summary;
}

std::optional<MapSummary> SummaryOf(const MapSnapshot& snapshot, MapId id) {
  const std::optional<LevelMap> map = FindLevelMap(snapshot, id);
  if (!map) return std::nullopt;
  return SummaryOf(*map);
}

std::vector<SessionSummary> SessionSummaries(const MapSnapshot& snapshot) {
  std::vector<SessionSummary> summaries;
  for (const SessionSnapshot& session : snapshot.sessions) summaries.push_back(SummaryOf(session));
  return summaries;
}

std::vector<MapSummary> MapSummaries(const MapSnapshot& snapshot) {
  std::set<MapId> ids;
  for (const SessionSnapshot& session : snapshot.sessions) ids.insert(session.map);
  std::vector<MapSummary> summaries;
  for (const MapId id : ids) {
    if (const auto summary = SummaryOf(snapshot, id)) summaries.push_back(*summary);
  }
  return summaries;
}

}  // namespace rovio_sfm
