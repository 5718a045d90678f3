#include "rovio_sfm/ros/camera_markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/map_frames.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;
using Color = std::array<float, 3>;

constexpr double kStepShare = 0.5;     // depth of a frustum: of the median step, at least ...
constexpr double kExtentShare = 0.04;  // ... of the path's extent

// The colours of sessions, again from the start when there are more.
constexpr std::array<Color, 6> kSessionColors = {{{0.12f, 0.47f, 0.71f},
                                                  {1.0f, 0.5f, 0.05f},
                                                  {0.17f, 0.63f, 0.17f},
                                                  {0.84f, 0.15f, 0.16f},
                                                  {0.58f, 0.4f, 0.74f},
                                                  {0.55f, 0.34f, 0.29f}}};

constexpr Color kAcceptedColor = {0.2f, 1.0f, 1.0f};
constexpr Color kProvisionalColor = {1.0f, 0.2f, 1.0f};
// Width of lines, of a frustum's depth: thin, as many stand close together.
constexpr double kLineShare = 0.04;

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

Marker Lines(const SessionSnapshot& session, const std::string& name, const Color& color,
             double width, const ros::Time& stamp) {
  Marker marker;
  marker.header.frame_id = SessionFrame(session.id);
  marker.header.stamp = stamp;
  marker.ns = name + "_" + std::to_string(session.id.value);
  marker.type = Marker::LINE_LIST;
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
  const double depth = FrustumDepth(poses);
  const Color& color = kSessionColors[(session.id.value - 1) % kSessionColors.size()];
  Marker marker = Lines(session, "session", color, kLineShare * depth, stamp);
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

// The overlaps with a verdict, one marker a session.
std::vector<Marker> OverlapLines(const MapSnapshot& snapshot,
                                 const std::vector<MergeReport>& merges, MergeVerdict verdict,
                                 const ros::Time& stamp) {
  const bool is_accepted = verdict == MergeVerdict::kAccepted;
  std::map<SessionId, Marker> markers;
  for (const MergeReport& report : merges) {
    const SessionSnapshot* other = FindSession(snapshot, report.other_session);
    const SessionSnapshot* query = FindSession(snapshot, report.query_session);
    if (report.verdict != verdict || other == nullptr || query == nullptr) continue;
    const auto [found, is_new] = markers.try_emplace(other->id);
    if (is_new) {
      const double width = kLineShare * FrustumDepth(LevelFromKeyframes(*other));
      found->second = Lines(*other, is_accepted ? "overlaps" : "provisional_overlaps",
                            is_accepted ? kAcceptedColor : kProvisionalColor, width, stamp);
    }
    AddOverlap(report, *other, *query, &found->second);
  }
  std::vector<Marker> lines;
  for (auto& [id, marker] : markers) lines.push_back(std::move(marker));
  return lines;
}

}  // namespace

visualization_msgs::MarkerArray CameraMarkers(const MapSnapshot& snapshot,
                                              const std::vector<MergeReport>& merges,
                                              const ros::Time& stamp) {
  visualization_msgs::MarkerArray markers;
  Marker clear;  // sessions that are gone
  clear.action = Marker::DELETEALL;
  clear.header.frame_id = MapFrame();
  markers.markers.push_back(clear);
  std::vector<Marker> lines;
  for (const SessionSnapshot& session : snapshot.sessions) lines.push_back(Frusta(session, stamp));
  for (const MergeVerdict verdict : {MergeVerdict::kAccepted, MergeVerdict::kProvisional}) {
    const auto overlaps = OverlapLines(snapshot, merges, verdict, stamp);
    lines.insert(lines.end(), overlaps.begin(), overlaps.end());
  }
  for (Marker& marker : lines) {
    if (!marker.points.empty()) markers.markers.push_back(std::move(marker));
  }
  return markers;
}

}  // namespace rovio_sfm
