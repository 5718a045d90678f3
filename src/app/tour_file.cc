#include "rovio_sfm/app/tour_file.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/app/option_reader.h"
#include "rovio_sfm/util/degrees.h"
#include "rovio_sfm/util/load_document.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxFileBytes = 1024 * 1024;
constexpr size_t kMaxWayPoints = 10000;
constexpr int kMaxPictures = 10000;  // between two way-points
constexpr double kMaxLength_m = 1000.0;

TourWayPoint ReadWayPoint(const YAML::Node& node, const std::string& path) {
  OptionReader reader(node, path);
  TourWayPoint point;
  double yaw_deg = 0.0;
  std::vector<double> center;
  reader.Read("x_m", &point.pose.x_m);
  reader.Read("y_m", &point.pose.y_m);
  reader.Read("yaw_deg", &yaw_deg);
  reader.Read("frames", &point.num_pictures);
  reader.Read("arc_center_m", &center);
  reader.RefuseUnknown();
  if (!(std::hypot(point.pose.x_m, point.pose.y_m) <= kMaxLength_m)) {
    reader.Fail("x_m, y_m", "expected numbers up to 1000");
  }
  if (!(std::abs(yaw_deg) <= 36000.0)) reader.Fail("yaw_deg", "expected -36000 to 36000");
  if (point.num_pictures < 1 || point.num_pictures > kMaxPictures) {
    reader.Fail("frames", "expected 1 to 10000");
  }
  if (!center.empty()) {
    if (center.size() != 2) reader.Fail("arc_center_m", "expected two numbers");
    point.arc_center_m = Eigen::Vector2d(center[0], center[1]);
  }
  point.pose.yaw_rad = Radians(yaw_deg);
  return point;
}

}  // namespace

std::vector<TourWayPoint> ParseTourWayPoints(const std::string& yaml, const std::string& source) {
  YAML::Node root;
  try {
    root = LoadDocument(yaml);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(source + ": " + error.what());
  }
  const YAML::Node list = root.IsMap() ? root["way_points"] : YAML::Node();
  if (!list.IsSequence() || list.size() == 0 || list.size() > kMaxWayPoints) {
    throw std::runtime_error(source + ": way_points: expected a list of 1 to 10000 way-points");
  }
  std::vector<TourWayPoint> way_points;
  for (size_t i = 0; i < list.size(); ++i) {
    way_points.push_back(ReadWayPoint(list[i], source + ": way_points[" + std::to_string(i) + "]"));
  }
  return way_points;
}

std::vector<TourWayPoint> LoadTourWayPoints(const std::string& path) {
  std::ifstream input(path, std::ios::binary);
  if (!input) throw std::runtime_error(path + ": cannot be read");
  std::string text(kMaxFileBytes + 1, '\0');
  input.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(input.gcount()));
  if (text.size() > kMaxFileBytes) throw std::runtime_error(path + ": too long for a tour");
  return ParseTourWayPoints(text, path);
}

}  // namespace rovio_sfm
