#include "rovio_sfm/rovio/tour_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

Eigen::Vector2d PositionOf(const PlanarPose& pose) { return {pose.x_m, pose.y_m}; }

// The place at this share of the way, round the centre if there is one; the radius changes evenly.
Eigen::Vector2d PositionAt(const PlanarPose& from, const TourWayPoint& to, double share) {
  const Eigen::Vector2d start = PositionOf(from), end = PositionOf(to.pose);
  if (!to.arc_center_m) return start + share * (end - start);
  const Eigen::Vector2d spoke = start - *to.arc_center_m;
  if (spoke.norm() < 1e-6) return start + share * (end - start);
  const double radius_m = spoke.norm() + share * ((end - *to.arc_center_m).norm() - spoke.norm());
  const Eigen::Rotation2Dd turn(share * (to.pose.yaw_rad - from.yaw_rad));
  return *to.arc_center_m + radius_m * (turn * spoke.normalized());
}

double Clamped(double value, double low, double high) {
  return std::copysign(std::clamp(std::abs(value), low, high), value);
}

}  // namespace

PlanarPose RelativeTo(const PlanarPose& origin, const PlanarPose& pose) {
  const Eigen::Vector2d offset =
      Eigen::Rotation2Dd(-origin.yaw_rad) * (PositionOf(pose) - PositionOf(origin));
  return {offset.x(), offset.y(), pose.yaw_rad - origin.yaw_rad};
}

std::vector<PlanarPose> PlanStops(const std::vector<TourWayPoint>& way_points) {
  const PlanarPose& origin = way_points.front().pose;
  std::vector<PlanarPose> stops = {{}};
  for (size_t i = 1; i < way_points.size(); ++i) {
    const PlanarPose& from = way_points[i - 1].pose;
    const TourWayPoint& to = way_points[i];
    for (int k = 1; k <= to.num_pictures; ++k) {
      const double share = static_cast<double>(k) / to.num_pictures;
      const Eigen::Vector2d position = PositionAt(from, to, share);
      const double yaw_rad = from.yaw_rad + share * (to.pose.yaw_rad - from.yaw_rad);
      stops.push_back(RelativeTo(origin, {position.x(), position.y(), yaw_rad}));
    }
  }
  return stops;
}

std::optional<BaseVelocity> SteerTo(const PlanarPose& target, const PlanarPose& present,
                                    const SteerOptions& options) {
  const PlanarPose error = RelativeTo(present, target);
  const double distance_m = std::hypot(error.x_m, error.y_m);
  const bool is_there = distance_m <= options.position_tolerance_m;
  const double turn_rad = std::abs(error.yaw_rad);
  if (turn_rad > (is_there ? options.yaw_tolerance_rad : options.turn_first_rad)) {
    return BaseVelocity{0.0, 0.0,
                        Clamped(error.yaw_rad / options.approach_s, options.min_turn_rad_per_s,
                                options.max_turn_rad_per_s)};
  }
  if (is_there) return std::nullopt;
  const double speed = std::clamp(distance_m / options.approach_s, options.min_speed_m_per_s,
                                  options.max_speed_m_per_s);
  return BaseVelocity{speed * error.x_m / distance_m, speed * error.y_m / distance_m, 0.0};
}

}  // namespace rovio_sfm
