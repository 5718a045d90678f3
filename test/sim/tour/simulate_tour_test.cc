#include "rovio_sfm/sim/tour/simulate_tour.h"

#include <gtest/gtest.h>

#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

TourSpec ShortTour() { return ParseTour(SmallTourYaml(), "short"); }

TEST(SimulateTour, GivesTheSameForTheSameSeed) {
  const SimulatedTour a = SimulateTour(ShortTour(), {}, 1), b = SimulateTour(ShortTour(), {}, 1);
  EXPECT_EQ(a.frames[4].world_from_camera.translation, b.frames[4].world_from_camera.translation);
  EXPECT_EQ(a.frames[4].odometry, b.frames[4].odometry);
}

TEST(SimulateTour, OdometryNeverChangesThePictures) {
  SlipOptions slippery;
  slippery.heading_walk_rad_per_sqrt_m = 0.5;
  const SimulatedTour a = SimulateTour(ShortTour(), {}, 1);
  const SimulatedTour b = SimulateTour(ShortTour(), slippery, 1);
  EXPECT_EQ(a.frames[6].world_from_camera.translation, b.frames[6].world_from_camera.translation);
  EXPECT_EQ(a.frames[6].exposure, b.frames[6].exposure);
  EXPECT_NE(a.frames[6].odometry, b.frames[6].odometry);
}

TEST(SimulateTour, OdometryIsTrueWithoutSlip) {
  SlipOptions none;
  none.forward_gain_spread = none.min_side_loss = none.max_side_loss = 0.0;
  none.heading_walk_rad_per_sqrt_m = none.lost_tick_share = 0.0;
  TourSpec tour = ShortTour();
  tour.step_spread = 0.0;
  const Eigen::Vector3d end = SimulateTour(tour, none, 1).frames.back().odometry;
  EXPECT_NEAR(end.x(), 0.6, 0.03);
  EXPECT_NEAR(end.y(), 0.3, 0.03);
  EXPECT_NEAR(end.z(), M_PI / 2, 0.03);
}

// The root of the mean square of error over sigma along a straight leg, over many drives: what a
// drive draws and what the driver takes for its uncertainty belong together.
TEST(SimulateTour, OdometryIsAsUncertainAsItSays) {
  TourSpec tour = ShortTour();
  tour.step_spread = 0.0;
  tour.way_points.pop_back();
  double sum = 0.0;
  constexpr int kDrives = 200;
  for (int seed = 1; seed <= kDrives; ++seed) {
    const TourFrame end = SimulateTour(tour, {}, static_cast<uint64_t>(seed)).frames.back();
    sum += std::pow(end.odometry.x() - 0.3, 2) / end.odometry_covariance(0, 0);
  }
  const double rms = std::sqrt(sum / kDrives);
  EXPECT_GT(rms, 0.4);
  EXPECT_LT(rms, 1.3);
}

TEST(SimulateTour, TruePoseLiesInTheMiddleOfTheSway) {
  const TourFrame frame = SimulateTour(ShortTour(), {}, 1).frames[2];
  const Rigid3 middle = PoseAt(frame.motion, 0.5);
  EXPECT_LT((middle.translation - frame.world_from_camera.translation).norm(), 1e-9);
}

TEST(SimulateTour, LightVariesByAStopAndAHalf) {
  TourSpec tour = ShortTour();
  tour.way_points[1].frames = 60;
  double low = 1e9, high = 0.0;
  for (const TourFrame& frame : SimulateTour(tour, {}, 3).frames) {
    low = std::min(low, frame.exposure);
    high = std::max(high, frame.exposure);
  }
  EXPECT_GT(std::log2(high / low), 1.5);
}

}  // namespace
}  // namespace rovio_sfm::sim
