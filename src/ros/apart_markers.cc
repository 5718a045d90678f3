#include "rovio_sfm/ros/apart_markers.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/markers.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr size_t kMaxPoints = 20000;  // of a map: an even choice of its landmarks
constexpr double kGapShare = 0.15;    // between two maps: of the wider one's width
constexpr double kTrim = 0.02;        // share of the points at each side that no width is made of
constexpr double kTextShare = 0.06;   // height of names: of a map's width
constexpr double kMinTextHeight = 0.15;

// A map as it is drawn. y runs to the left.
struct Sheet {
  LevelMap map;
  std::vector<CloudPoint> cloud;
  std::vector<PosedImage> images;
  double right = 0.0, left = 0.0;  // least and greatest y, the outermost points left out

  double Width() const { return left - right; }
};

Sheet MakeSheet(LevelMap map) {
  Sheet sheet;
  sheet.cloud = LevelCloud(map);
  sheet.images = PosedImages(map);
  sheet.map = std::move(map);
  std::vector<double> ys;
  for (const CloudPoint& point : sheet.cloud) ys.push_back(point.x_in_map.y());
  for (const PosedImage& image : sheet.images) {
    ys.push_back(image.level_from_camera.reference_from_body.translation.y());
  }
  if (ys.empty()) return sheet;
  std::sort(ys.begin(), ys.end());
  const auto trimmed = static_cast<size_t>(kTrim * static_cast<double>(ys.size()));
  sheet.right = ys[trimmed];
  sheet.left = ys[ys.size() - 1 - trimmed];
  return sheet;
}

geometry_msgs::Point PointAt(const Eigen::Vector3d& x_in_map, double shift_y) {
  geometry_msgs::Point point;
  point.x = x_in_map.x();
  point.y = x_in_map.y() + shift_y;
  point.z = x_in_map.z();
  return point;
}

std::string NameOf(const LevelMap& map) { return "map_" + std::to_string(map.id.value); }

Marker PointsOf(const Sheet& sheet, double shift_y, const ros::Time& stamp) {
  Marker marker =
      MakeMarker(MapFrame(), NameOf(sheet.map) + "/points", Marker::POINTS, Marker::ADD, stamp);
  marker.scale.x = marker.scale.y = 0.002 * std::max(sheet.Width(), 1.0);
  const size_t step = 1 + sheet.cloud.size() / kMaxPoints;
  for (size_t i = 0; i < sheet.cloud.size(); i += step) {
    const CloudPoint& point = sheet.cloud[i];
    marker.points.push_back(PointAt(point.x_in_map, shift_y));
    std_msgs::ColorRGBA color;
    color.r = static_cast<float>(point.color[0]) / 255.0f;
    color.g = static_cast<float>(point.color[1]) / 255.0f;
    color.b = static_cast<float>(point.color[2]) / 255.0f;
    color.a = 1.0f;
    marker.colors.push_back(color);
  }
  return marker;
}

// A line for each drive of the map.
std::vector<Marker> PathsOf(const Sheet& sheet, double shift_y, const ros::Time& stamp) {
  std::vector<Marker> markers;
  const DriveId* drive = nullptr;
  for (const PosedImage& image : sheet.images) {
    if (drive == nullptr || !(*drive == image.id.drive)) {
      markers.push_back(MakeMarker(MapFrame(), NameOf(sheet.map) + "/path", Marker::LINE_STRIP,
                                   Marker::ADD, stamp));
      markers.back().id = static_cast<int>(markers.size());
      drive = &image.id.drive;
    }
    markers.back().points.push_back(
        PointAt(image.level_from_camera.reference_from_body.translation, shift_y));
  }
  const auto is_short = [](const Marker& marker) { return marker.points.size() < 2; };
  markers.erase(std::remove_if(markers.begin(), markers.end(), is_short), markers.end());
  for (Marker& marker : markers) {
    PaintLine(SessionColor(sheet.map.sessions.front().id), &marker);
  }
  return markers;
}

// "map 2, apart: rovio2", over its middle.
Marker TitleOf(const Sheet& sheet, double shift_y, const ros::Time& stamp) {
  Marker marker = MakeMarker(MapFrame(), NameOf(sheet.map) + "/name", Marker::TEXT_VIEW_FACING,
                             Marker::ADD, stamp);
  std::set<std::string> robots;
  for (const SessionSnapshot& session : sheet.map.sessions) robots.insert(session.drive.robot);
  marker.text = "map " + std::to_string(sheet.map.id.value) + ", apart:";
  for (const std::string& robot : robots) marker.text += " " + robot;
  if (!sheet.map.scale) marker.text += " (map units)";
  marker.scale.z = std::max(kTextShare * sheet.Width(), kMinTextHeight);
  marker.color.r = marker.color.g = marker.color.b = 1.0f;
  marker.pose.position.y = 0.5 * (sheet.left + sheet.right) + shift_y;
  marker.pose.position.z = 3.0 * marker.scale.z;
  return marker;
}

}  // namespace

MarkerArray ApartMarkers(const MapSnapshot& snapshot, const ros::Time& stamp) {
  MarkerArray markers;
  markers.markers.push_back(ClearMarkers(stamp));
  const SessionSnapshot* root = FindRoot(snapshot);
  if (root == nullptr) return markers;
  std::set<MapId> others;
  for (const SessionSnapshot& session : snapshot.sessions) others.insert(session.map);
  others.erase(root->map);
  const auto root_map = FindLevelMap(snapshot, root->map);
  if (!root_map || others.empty()) return markers;
  const Sheet root_sheet = MakeSheet(*root_map);
  double edge = root_sheet.right;
  double width = root_sheet.Width();
  for (const MapId id : others) {
    std::optional<LevelMap> map = FindLevelMap(snapshot, id);
    if (!map) continue;
    const Sheet sheet = MakeSheet(std::move(*map));
    const double shift_y = edge - kGapShare * std::max(width, sheet.Width()) - sheet.left;
    markers.markers.push_back(PointsOf(sheet, shift_y, stamp));
    for (Marker& path : PathsOf(sheet, shift_y, stamp)) markers.markers.push_back(std::move(path));
    markers.markers.push_back(TitleOf(sheet, shift_y, stamp));
    edge = sheet.right + shift_y;
    width = sheet.Width();
  }
  return markers;
}

}  // namespace rovio_sfm
