#include "rovio_sfm/ros/map_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>

#include "rovio_sfm/pipeline/map_statistics.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"

namespace rovio_sfm {
namespace {

using sensor_msgs::PointField;

constexpr double kStepShare = 0.5;     // depth of a frustum: of the median step, at least ...
constexpr double kExtentShare = 0.04;  // ... of the path's extent

// The colours of sessions, again from the start when there are more.
constexpr std::array<std::array<float, 3>, 6> kSessionColors = {{{0.12f, 0.47f, 0.71f},
                                                                 {1.0f, 0.5f, 0.05f},
                                                                 {0.17f, 0.63f, 0.17f},
                                                                 {0.84f, 0.15f, 0.16f},
                                                                 {0.58f, 0.4f, 0.74f},
                                                                 {0.55f, 0.34f, 0.29f}}};

// Calls visit for every frame with a pose of its own.
template <typename Visit>
void ForEachRegistered(const SessionSnapshot& session, const Visit& visit) {
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      if (!frame.weak) visit(frame);
    }
  }
}

std::vector<Rigid3> LevelFromKeyframes(const SessionSnapshot& session) {
  std::vector<Rigid3> poses;
  ForEachRegistered(session, [&](const FrameSnapshot& frame) {
    if (frame.kind != FrameKind::kKeyframe) return;
    if (const auto pose = CameraInLevel(session, frame)) poses.push_back(*pose);
  });
  return poses;
}

double MedianStep(const std::vector<Rigid3>& poses) {
  std::vector<double> steps;
  for (size_t i = 1; i < poses.size(); ++i) {
    steps.push_back((poses[i].translation - poses[i - 1].translation).norm());
  }
  if (steps.empty()) return 1.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(*middle, 1e-3);
}

// So that frusta neither vanish nor hide each other, whatever the unit.
double FrustumDepth(const std::vector<Rigid3>& poses) {
  Eigen::AlignedBox3d box;
  for (const Rigid3& pose : poses) box.extend(pose.translation);
  const double extent = poses.empty() ? 0.0 : box.diagonal().norm();
  return std::max(kStepShare * MedianStep(poses), kExtentShare * extent);
}

geometry_msgs::Point ToPoint(const Eigen::Vector3d& x) {
  geometry_msgs::Point point;
  point.x = x.x();
  point.y = x.y();
  point.z = x.z();
  return point;
}

// Eight edges: from the centre to the image's corners, and round the image.
void AddFrustum(const Rigid3& level_from_camera, const Camera& camera, double depth,
                visualization_msgs::Marker* marker) {
  const double x = 0.5 * camera.width / camera.fx * depth;
  const double y = 0.5 * camera.height / camera.fy * depth;
  const geometry_msgs::Point center = ToPoint(level_from_camera.translation);
  std::array<geometry_msgs::Point, 4> corners;
  const std::array<std::array<double, 2>, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d corner(signs[i][0] * x, signs[i][1] * y, depth);
    corners[i] = ToPoint(level_from_camera * corner);
  }
  for (size_t i = 0; i < 4; ++i) {
    marker->points.push_back(center);
    marker->points.push_back(corners[i]);
    marker->points.push_back(corners[i]);
    marker->points.push_back(corners[(i + 1) % 4]);
  }
}

visualization_msgs::Marker Frusta(const SessionSnapshot& session, const ros::Time& stamp) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = SessionFrame(session.id);
  marker.header.stamp = stamp;
  marker.ns = "session_" + std::to_string(session.id.value);
  marker.type = visualization_msgs::Marker::LINE_LIST;
  const auto& color = kSessionColors[(session.id.value - 1) % kSessionColors.size()];
  marker.color.r = color[0];
  marker.color.g = color[1];
  marker.color.b = color[2];
  marker.color.a = 1.0f;
  marker.pose.orientation.w = 1.0;
  const std::vector<Rigid3> poses = LevelFromKeyframes(session);
  const double depth = FrustumDepth(poses);
  marker.scale.x = 0.04 * depth;
  for (const Rigid3& pose : poses) AddFrustum(pose, session.camera, depth, &marker);
  return marker;
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

visualization_msgs::MarkerArray CameraMarkers(const MapSnapshot& snapshot, const ros::Time& stamp) {
  visualization_msgs::MarkerArray markers;
  visualization_msgs::Marker clear;  // sessions that are gone
  clear.action = visualization_msgs::Marker::DELETEALL;
  clear.header.frame_id = MapFrame();
  markers.markers.push_back(clear);
  for (const SessionSnapshot& session : snapshot.sessions) {
    visualization_msgs::Marker frusta = Frusta(session, stamp);
    if (!frusta.points.empty()) markers.markers.push_back(std::move(frusta));
  }
  return markers;
}

SessionSummary SummaryOf(const SessionSnapshot& session) {
  SessionSummary summary;
  summary.session = session.id.value;
  summary.map = session.map.value;
  summary.state = static_cast<uint8_t>(session.state);
  summary.drive = ToMessage(session.drive);
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
    if (const auto map = FindLevelMap(snapshot, id)) summaries.push_back(SummaryOf(*map));
  }
  return summaries;
}

}  // namespace rovio_sfm
