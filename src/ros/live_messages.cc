#include "rovio_sfm/ros/live_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "rovio_sfm/report/page_data.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/util/base64.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;
using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;
using visualization_msgs::Marker;

std::string TextOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

double Short(double value) { return std::round(value * 1e4) / 1e4; }

bool HasField(const PointCloud2& cloud, const std::string& name, uint8_t type) {
  return std::any_of(cloud.fields.begin(), cloud.fields.end(), [&](const PointField& field) {
    return field.name == name && field.datatype == type && field.count == 1 &&
           field.offset + uint64_t{4} <= cloud.point_step;
  });
}

// Why the points cannot be read; empty where they can.
std::string FaultOf(const PointCloud2& cloud) {
  for (const char* name : {"x", "y", "z", "rgb"}) {
    if (!HasField(cloud, name, PointField::FLOAT32)) {
      return std::string("cloud field ") + name + ": expected one float32";
    }
  }
  for (const char* name : {"session", "views"}) {
    if (!HasField(cloud, name, PointField::UINT32)) {
      return std::string("cloud field ") + name + ": expected one uint32";
    }
  }
  const uint64_t row = uint64_t{cloud.width} * cloud.point_step;
  if (cloud.row_step != row || cloud.data.size() != row * cloud.height || cloud.is_bigendian) {
    return "cloud data: expected little-endian width * height points without gaps";
  }
  return "";
}

uint8_t Byte(uint32_t value) { return static_cast<uint8_t>(std::min(value, 255u)); }

void AddPoints(const std::vector<geometry_msgs::Point>& points, Json* json) {
  std::vector<float> positions;
  positions.reserve(3 * points.size());
  for (const geometry_msgs::Point& point : points) {
    for (const double value : {point.x, point.y, point.z}) {
      positions.push_back(static_cast<float>(value));
    }
  }
  (*json)["positions"] = Base64Of(positions);
}

uint8_t Channel(float value) { return static_cast<uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255); }

Json ShapeOf(const Marker& marker) {
  Json shape = {
      {"type", marker.type},
      {"session", SessionOfFrame(marker.header.frame_id).value_or(0)},
      {"color", {Channel(marker.color.r), Channel(marker.color.g), Channel(marker.color.b)}}};
  AddPoints(marker.points, &shape);
  if (marker.type == Marker::TEXT_VIEW_FACING) {
    shape["text"] = marker.text;
    const geometry_msgs::Point& at = marker.pose.position;
    shape["at"] = {Short(at.x), Short(at.y), Short(at.z)};
    shape["height"] = Short(marker.scale.z);
  }
  if (marker.colors.size() == marker.points.size()) {
    std::vector<uint8_t> colors;
    for (const auto& color : marker.colors) {
      for (const float value : {color.r, color.g, color.b}) colors.push_back(Channel(value));
    }
    shape["colors"] = Base64(colors);
  }
  return shape;
}

}  // namespace

std::optional<std::string> LiveCloud(const PointCloud2& cloud, std::string* error) {
  *error = FaultOf(cloud);
  if (!error->empty()) return std::nullopt;
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x"), y(cloud, "y"), z(cloud, "z");
  sensor_msgs::PointCloud2ConstIterator<uint8_t> bgr(cloud, "rgb");
  sensor_msgs::PointCloud2ConstIterator<uint32_t> session(cloud, "session"), views(cloud, "views");
  const size_t count = cloud.data.size() / std::max(cloud.point_step, 1u);
  const auto step = static_cast<int>(count / kMaxPagePoints + 1);
  std::vector<float> positions;
  std::vector<uint8_t> colors, sessions, all_views;
  for (size_t i = 0; i < count; i += static_cast<size_t>(step)) {
    positions.insert(positions.end(), {*x, *y, *z});
    colors.insert(colors.end(), {bgr[2], bgr[1], bgr[0]});
    sessions.push_back(static_cast<uint8_t>((*session - 1) % 256));
    all_views.push_back(Byte(*views));
    x += step, y += step, z += step, bgr += step, session += step, views += step;
  }
  return TextOf({{"count", positions.size() / 3},
                 {"total", count},
                 {"positions", Base64Of(positions)},
                 {"colors", Base64(colors)},
                 {"sessions", Base64(sessions)},
                 {"views", Base64(all_views)}});
}

std::string LiveLines(const Marker& marker) { return TextOf(ShapeOf(marker)); }

std::string LiveShapes(const visualization_msgs::MarkerArray& markers) {
  Json shapes = Json::array();
  for (const Marker& marker : markers.markers) {
    if (marker.action == Marker::ADD) shapes.push_back(ShapeOf(marker));
  }
  return TextOf(shapes);
}

std::string LivePose(const geometry_msgs::Pose& pose) {
  const auto& [at, turn] = std::tie(pose.position, pose.orientation);
  return TextOf(Json::array({at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w}));
}

std::string LivePose(const geometry_msgs::Transform& transform) {
  geometry_msgs::Pose pose;
  pose.position.x = transform.translation.x;
  pose.position.y = transform.translation.y;
  pose.position.z = transform.translation.z;
  pose.orientation = transform.rotation;
  return LivePose(pose);
}

std::optional<uint32_t> SessionOfFrame(const std::string& frame_id) {
  static constexpr char kBegin[] = "session_";
  uint32_t session = 0;
  if (frame_id.compare(0, sizeof(kBegin) - 1, kBegin) != 0) return std::nullopt;
  std::from_chars(frame_id.data() + sizeof(kBegin) - 1, frame_id.data() + frame_id.size(), session);
  if (session == 0 || SessionFrame(SessionId{session}) != frame_id) return std::nullopt;
  return session;
}

}  // namespace rovio_sfm
