#include "rovio_sfm/sim/tour/simulate_tour.h"

#include <cmath>

#include "rovio_sfm/rovio/omni_odometry.h"
#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm::sim {
namespace {

// A robot at rest still sways a little; this blurs a picture by some tenths of a pixel.
constexpr double kSway_rad = 0.0004, kSway_m = 0.0002;

CameraMotion SwayAround(const Rigid3& world_from_camera, Rng& rng) {
  const Eigen::Vector3d turn =
      0.5 * kSway_rad * Eigen::Vector3d(rng.Gaussian(), rng.Gaussian(), rng.Gaussian());
  const Eigen::Vector3d shift =
      0.5 * kSway_m * Eigen::Vector3d(rng.Gaussian(), rng.Gaussian(), rng.Gaussian());
  const auto turned = [&](double sign) {
    const Eigen::AngleAxisd rotation(sign * turn.norm(), turn.normalized());
    return Rigid3{(world_from_camera.rotation * rotation).normalized(),
                  world_from_camera.translation + sign * shift};
  };
  return {turned(-1.0), turned(1.0)};
}

// Auto-exposure that hunts: a slow wave over the tour with a little flicker, full range in stops.
double ExposureStops(const TourSpec& tour, double progress, double phase, Rng& rng) {
  const double wave = 0.5 * tour.exposure_stops * std::sin(phase + 2.0 * M_PI * 1.1 * progress);
  return wave + 0.03 * rng.Gaussian();
}

// What the wheels must have turned for the floor to give this motion.
BodyMotion RimMotion(const PlanarPose& from, const PlanarPose& to, const Slip& slip,
                     double heading_error_rad) {
  const double heading = 0.5 * (from.yaw_rad + to.yaw_rad);
  const double dx = to.x_m - from.x_m, dy = to.y_m - from.y_m;
  const double c = std::cos(heading), s = std::sin(heading);
  return {(c * dx + s * dy) / slip.forward_gain, (-s * dx + c * dy) / slip.side_gain,
          (to.yaw_rad - from.yaw_rad) / slip.turn_gain + heading_error_rad};
}

// Counted ticks as the robot reports them.
std::array<WheelTicks, 3> AsReported(const std::array<int, 3>& counted) {
  std::array<WheelTicks, 3> wheels;
  for (size_t wheel = 0; wheel < 3; ++wheel) {
    if (counted[wheel] == 0) continue;
    wheels[wheel].direction = counted[wheel] < 0 ? 0x02 : 0x05;
    wheels[wheel].ticks = static_cast<uint16_t>(std::abs(counted[wheel]));
  }
  return wheels;
}

void AddOdometry(const std::vector<PlanarPose>& poses, const SlipOptions& options, Rng rng,
                 SimulatedTour* tour) {
  const OmniGeometry geometry;
  const Slip slip = DrawSlip(options, rng);
  TickCounter counter(geometry, options.lost_tick_share, rng.Fork(1));
  OmniOdometry odometry(OmniOdometryOptions{});
  for (size_t i = 1; i < poses.size(); ++i) {
    const double way_m =
        std::hypot(poses[i].x_m - poses[i - 1].x_m, poses[i].y_m - poses[i - 1].y_m);
    const double error = options.heading_walk_rad_per_sqrt_m * std::sqrt(way_m) * rng.Gaussian();
    const BodyMotion motion = RimMotion(poses[i - 1], poses[i], slip, error);
    odometry.Add(AsReported(counter.Add(RimTravel(motion, geometry))));
    const OdometryState& state = odometry.State();
    tour->frames[i].odometry = {state.x_m, state.y_m, state.yaw_rad};
    tour->frames[i].odometry_covariance = state.covariance;
  }
}

}  // namespace

SimulatedTour SimulateTour(const TourSpec& spec, const SlipOptions& slip, uint64_t seed) {
  ROVIO_CHECK(spec.IsValid(nullptr) && slip.IsValid(nullptr));
  const std::vector<PlanarPose> poses = PlanTour(spec, seed);
  Rng rng(seed ^ 0x666c6f6f72ULL);
  const double phase = rng.Uniform(0.0, 2.0 * M_PI);
  SimulatedTour tour;
  tour.base_from_camera = BaseFromCamera(spec.head_position);
  for (const PlanarPose& pose : poses) {
    const double index = static_cast<double>(tour.frames.size());
    const double progress = index / static_cast<double>(poses.size());
    TourFrame frame;
    frame.time_s = 1.0 + spec.interval_s * index;
    frame.world_from_camera =
        WorldFromBase(pose.x_m, pose.y_m, pose.yaw_rad, DrawRocking(rng)) * tour.base_from_camera;
    frame.motion = SwayAround(frame.world_from_camera, rng);
    frame.exposure = spec.exposure * std::exp2(ExposureStops(spec, progress, phase, rng));
    tour.frames.push_back(frame);
  }
  AddOdometry(poses, slip, Rng(seed ^ 0x6f646f6d65747279ULL), &tour);
  return tour;
}

}  // namespace rovio_sfm::sim
