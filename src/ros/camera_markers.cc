#include "rovio_sfm/ros/camera_markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/markers.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;
using Color = std::array<float, 3>;

constexpr double kStepShare = 0.5;     // depth of a frustum: of the median step, at least ...
constexpr double kExtentShare = 0.04;  // ... of the path's extent

constexpr Color kAcceptedColor = {0.2f, 1.0f, 1.0f};
constexpr Color kProvisionalColor = {1.0f, 0.2f, 1.0f};
// Width of lines, of a frustum's depth: thin, as many stand close together.
constexpr double kLineShare = 0.04;

// Of the markers' namespaces: each is one of these and a session's number.
constexpr char kFrusta[] = "session";
constexpr char kAcceptedOverlaps[] = "overlaps";
constexpr char kProvisionalOverlaps[] = "provisional_overlaps";

std::vector<Rigid3> LevelFromKeyframes(const SessionSnapshot& session) {
  std::vector<Rigid3> poses;
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      if (frame.weak || frame.kind != FrameKind::kKeyframe) continue;
      if (const auto pose = CameraInLevel(session, frame)) poses.push_back(*pose);
    }
  }
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
                Marker* marker) {
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

// Deletes what was drawn of a session, until it has lines.
Marker NoLines(SessionId session, const std::string& name, const ros::Time& stamp) {
  Marker marker;
  marker.header.frame_id = SessionFrame(session);
  marker.header.stamp = stamp;
  marker.ns = name + "_" + std::to_string(session.value);
  marker.type = Marker::LINE_LIST;
  marker.action = Marker::DELETE;
  return marker;
}

Marker Lines(const SessionSnapshot& session, const std::string& name, const Color& color,
             double width, const ros::Time& stamp) {
  Marker marker = NoLines(session.id, name, stamp);
  marker.action = Marker::ADD;
  marker.color.r = color[0];
  marker.color.g = color[1];
  marker.color.b = color[2];
  marker.color.a = 1.0f;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = width;
  return marker;
}

Marker Frusta(const SessionSnapshot& session, const ros::Time& stamp) {
  const std::vector<Rigid3> poses = LevelFromKeyframes(session);
  if (poses.empty()) return NoLines(session.id, kFrusta, stamp);
  const double depth = FrustumDepth(poses);
  Marker marker = Lines(session, kFrusta, SessionColor(session.id), kLineShare * depth, stamp);
  for (const Rigid3& pose : poses) AddFrustum(pose, session.camera, depth, &marker);
  return marker;
}

std::optional<Eigen::Vector3d> CenterInSession(const SessionSnapshot& session, const FrameId& id) {
  const FrameSnapshot* frame = id.drive == session.drive ? FindFrame(session, id.index) : nullptr;
  if (frame == nullptr) return std::nullopt;
  return OriginInA(frame->cam_from_session);
}

// Adds the edge of an overlap to the lines in the frame of its other session; nothing where one of
// its frames has no pose (any more).
void AddOverlap(const MergeReport& report, const SessionSnapshot& other,
                const SessionSnapshot& query, Marker* marker) {
  const auto level_from_other = LevelInUnitOfMap(other);
  const auto other_center = CenterInSession(other, report.other);
  const auto query_center = CenterInSession(query, report.query);
  if (!level_from_other || !other_center || !query_center) return;
  const Sim3 other_from_query = report.verdict == MergeVerdict::kAccepted
                                    ? Inverse(other.map_from_session) * query.map_from_session
                                    : Inverse(report.query_from_other);
  marker->points.push_back(ToPoint(*level_from_other * *other_center));
  marker->points.push_back(ToPoint(*level_from_other * (other_from_query * *query_center)));
}

// The overlaps of a session (as the other) that have a verdict.
Marker OverlapLines(const MapSnapshot& snapshot, const std::vector<MergeReport>& merges,
                    const SessionSnapshot& other, MergeVerdict verdict, const ros::Time& stamp) {
  const bool is_accepted = verdict == MergeVerdict::kAccepted;
  const double width = kLineShare * FrustumDepth(LevelFromKeyframes(other));
  Marker marker = Lines(other, is_accepted ? kAcceptedOverlaps : kProvisionalOverlaps,
                        is_accepted ? kAcceptedColor : kProvisionalColor, width, stamp);
  for (const MergeReport& report : merges) {
    if (report.verdict != verdict || !(report.other_session == other.id)) continue;
    const SessionSnapshot* query = FindSession(snapshot, report.query_session);
    if (query != nullptr) AddOverlap(report, other, *query, &marker);
  }
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}

// Of a session that is gone: what deletes them.
void AddOverlaps(const MapSnapshot& snapshot, const std::vector<MergeReport>& merges, SessionId id,
                 const ros::Time& stamp, std::vector<Marker>* markers) {
  const SessionSnapshot* other = FindSession(snapshot, id);
  if (other == nullptr) {
    markers->push_back(NoLines(id, kAcceptedOverlaps, stamp));
    markers->push_back(NoLines(id, kProvisionalOverlaps, stamp));
    return;
  }
  for (const MergeVerdict verdict : {MergeVerdict::kAccepted, MergeVerdict::kProvisional}) {
    markers->push_back(OverlapLines(snapshot, merges, *other, verdict, stamp));
  }
}

}  // namespace

visualization_msgs::MarkerArray ChangedCameraMarkers(const MapSnapshot& snapshot,
                                                     const std::vector<MergeReport>& merges,
                                                     const SessionChanges& changes,
                                                     const ros::Time& stamp) {
  visualization_msgs::MarkerArray markers;
  for (const SessionId id : changes.gone) markers.markers.push_back(NoLines(id, kFrusta, stamp));
  for (const SessionId id : changes.sessions) {
    markers.markers.push_back(Frusta(*FindSession(snapshot, id), stamp));
  }
  for (const SessionId id : changes.overlaps) {
    AddOverlaps(snapshot, merges, id, stamp, &markers.markers);
  }
  return markers;
}

visualization_msgs::MarkerArray CameraMarkers(const MapSnapshot& snapshot,
                                              const std::vector<MergeReport>& merges,
                                              const ros::Time& stamp) {
  SessionChanges all;
  for (const SessionSnapshot& session : snapshot.sessions) all.sessions.push_back(session.id);
  for (const MergeReport& report : merges) {
    if (FindSession(snapshot, report.other_session)) all.overlaps.insert(report.other_session);
  }
  const auto parts = ChangedCameraMarkers(snapshot, merges, all, stamp).markers;
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(ClearMarkers(stamp));
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(markers.markers),
               [](const Marker& marker) { return marker.action == Marker::ADD; });
  return markers;
}

}  // namespace rovio_sfm
