#include "rovio_sfm/sim/tour/tour.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/util/degrees.h"
#include "rovio_sfm/util/load_document.h"
#include "rovio_sfm/util/option_checker.h"
#include "rovio_sfm/util/rng.h"
#include "rovio_sfm/util/yaml_map.h"

namespace rovio_sfm::sim {
namespace {

Eigen::Vector2d ReadPoint(YamlMap* map, const char* key) {
  const std::vector<double> point = map->Numbers(key, 2);
  return {point[0], point[1]};
}

WayPoint ReadWayPoint(YamlMap map) {
  WayPoint point;
  point.x_m = map.Number("x_m");
  point.y_m = map.Number("y_m");
  point.yaw_rad = Radians(map.Number("yaw_deg"));
  point.frames = map.Integer("frames", 1);
  if (map.Has("arc_center_m")) point.arc_center_m = ReadPoint(&map, "arc_center_m");
  map.RefuseUnknownKeys();
  return point;
}

MoverSpec ReadMover(YamlMap map) {
  MoverSpec mover;
  mover.world = map.Text("world");
  mover.from_m = ReadPoint(&map, "from_m");
  mover.to_m = ReadPoint(&map, "to_m");
  mover.speed_m_s = map.Number("speed_m_s", mover.speed_m_s);
  map.RefuseUnknownKeys();
  return mover;
}

// The pose at a share of the way between two way-points.
PlanarPose Between(const WayPoint& from, const WayPoint& to, double share) {
  const double yaw = from.yaw_rad + share * (to.yaw_rad - from.yaw_rad);
  const Eigen::Vector2d start(from.x_m, from.y_m), end(to.x_m, to.y_m);
  if (!to.arc_center_m) {
    const Eigen::Vector2d at = start + share * (end - start);
    return {at.x(), at.y(), yaw};
  }
  const Eigen::Vector2d spoke = start - *to.arc_center_m;
  const double radius_m = spoke.norm() + share * ((end - *to.arc_center_m).norm() - spoke.norm());
  const double angle = std::atan2(spoke.y(), spoke.x()) + yaw - from.yaw_rad;
  const Eigen::Vector2d at =
      *to.arc_center_m + radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  return {at.x(), at.y(), yaw};
}

// True if the arc (if there is one) ends where the way-point lies.
bool EndsAtItsPoint(const WayPoint& from, const WayPoint& to) {
  constexpr double kNear_m = 0.05;
  const PlanarPose end = Between(from, to, 1.0);
  return std::hypot(end.x_m - to.x_m, end.y_m - to.y_m) < kNear_m;
}

// Nobody puts a robot down exactly on its mark.
PlanarPose Jitter(const PlanarPose& pose, double step_m, double spread, Rng& rng) {
  const double yaw_spread = std::min(0.5 * spread * Radians(5.0), 0.02);
  return {pose.x_m + spread * step_m * rng.Gaussian() * 0.5,
          pose.y_m + spread * step_m * rng.Gaussian() * 0.5,
          pose.yaw_rad + yaw_spread * rng.Gaussian()};
}

}  // namespace

bool TourSpec::IsValid(std::string* error) const {
  OptionChecker check("tour " + name, error);
  check.Range("head_position", head_position, 60.0, 210.0);
  check.Range("interval_s", interval_s, 0.01, 3600.0);
  check.Range("step_spread", step_spread, 0.0, 0.5);
  check.Range("exposure", exposure, 0.01, 100.0);
  check.Range("exposure_stops", exposure_stops, 0.0, 4.0);
  check.True("way_points", way_points.size() >= 2 && way_points.size() <= 1000, "2 to 1000");
  for (const WayPoint& point : way_points) {
    check.Range("frames", point.frames, 1, 5000);
    check.Range("x_m", point.x_m, -1000.0, 1000.0);
    check.Range("y_m", point.y_m, -1000.0, 1000.0);
    check.Range("yaw_rad", point.yaw_rad, -100.0, 100.0);
  }
  for (size_t i = 1; i < way_points.size(); ++i) {
    check.True(("way_points[" + std::to_string(i) + "]").c_str(),
               EndsAtItsPoint(way_points[i - 1], way_points[i]),
               "a place on its arc (turned by the change of yaw)");
  }
  for (const MoverSpec& mover : movers) check.Nested(mover);
  return check.Passed();
}

TourSpec ParseTour(const std::string& yaml, const std::string& source) {
  try {
    YamlMap map(LoadDocument(yaml), source, ": ");
    TourSpec tour;
    tour.name = map.Text("name");
    tour.world = map.Text("world");
    tour.head_position = map.Number("head_position", tour.head_position);
    tour.interval_s = map.Number("interval_s", tour.interval_s);
    tour.step_spread = map.Number("step_spread", tour.step_spread);
    tour.exposure = map.Number("exposure", tour.exposure);
    tour.exposure_stops = map.Number("exposure_stops", tour.exposure_stops);
    tour.shares_with = map.Texts("shares_with");
    for (const YamlMap& item : map.List("way_points"))
      tour.way_points.push_back(ReadWayPoint(item));
    for (const YamlMap& item : map.List("movers")) tour.movers.push_back(ReadMover(item));
    map.RefuseUnknownKeys();
    std::string error;
    if (!tour.IsValid(&error)) throw std::runtime_error(source + ": " + error);
    return tour;
  } catch (const YAML::Exception& exception) {
    throw std::runtime_error(source + ": " + exception.what());
  }
}

TourSpec LoadTour(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return ParseTour(text.str(), path);
}

TourSpec WithLongerSteps(TourSpec tour, double times) {
  for (WayPoint& point : tour.way_points) {
    point.frames = std::max(1, static_cast<int>(std::lround(point.frames / times)));
  }
  return tour;
}

Movers LoadMovers(const TourSpec& tour, const std::string& config_folder) {
  if (tour.movers.empty()) {
    throw std::runtime_error("tour " + tour.name +
                             ": movers: expected at least one, or no --movers");
  }
  return {tour.movers, config_folder + "/worlds"};
}

std::vector<PlanarPose> PlanTour(const TourSpec& tour, uint64_t seed) {
  Rng rng(seed ^ 0x746f7572ULL);
  const WayPoint& start = tour.way_points.front();
  std::vector<PlanarPose> poses{{start.x_m, start.y_m, start.yaw_rad}};
  for (size_t i = 1; i < tour.way_points.size(); ++i) {
    const WayPoint& from = tour.way_points[i - 1];
    const WayPoint& to = tour.way_points[i];
    for (int k = 1; k <= to.frames; ++k) {
      const PlanarPose before = Between(from, to, static_cast<double>(k - 1) / to.frames);
      const PlanarPose at = Between(from, to, static_cast<double>(k) / to.frames);
      const double step_m = std::hypot(at.x_m - before.x_m, at.y_m - before.y_m);
      poses.push_back(Jitter(at, step_m, tour.step_spread, rng));
    }
  }
  return poses;
}

}  // namespace rovio_sfm::sim
