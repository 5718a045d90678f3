#include "rovio_sfm/rovio/tour_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(PlanStops, BeginsAtTheOriginAndDividesTheWayEvenly) {
  const std::vector<PlanarPose> stops =
      PlanStops({{{1.0, 2.0, M_PI / 2}, 1, {}}, {{1.0, 4.0, M_PI / 2 + 0.4}, 4, {}}});
  ASSERT_EQ(stops.size(), 5u);
  EXPECT_NEAR(stops[0].x_m, 0.0, 1e-9);
  for (size_t i = 0; i < 5; ++i) {  // straight ahead, in the robot's own eyes
    EXPECT_NEAR(stops[i].x_m, 0.5 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(stops[i].y_m, 0.0, 1e-9);
    EXPECT_NEAR(stops[i].yaw_rad, 0.1 * static_cast<double>(i), 1e-9);
  }
}

TEST(PlanStops, GoesRoundACentreWithTheHeadingTurningAlong) {
  const Eigen::Vector2d center(0.0, 0.0);
  const std::vector<PlanarPose> stops =
      PlanStops({{{1.0, 0.0, M_PI}, 1, {}}, {{1.0, 0.0, 3 * M_PI}, 8, center}});
  ASSERT_EQ(stops.size(), 9u);
  for (const PlanarPose& stop : stops) {  // the centre is a metre before the start
    EXPECT_NEAR(std::hypot(stop.x_m - 1.0, stop.y_m), 1.0, 1e-9);
  }
  EXPECT_NEAR(stops.back().yaw_rad, 2 * M_PI, 1e-9);
}

// Where the robot gets in a tenth of a second.
PlanarPose Moved(const PlanarPose& pose, const BaseVelocity& velocity) {
  const double cosine = std::cos(pose.yaw_rad), sine = std::sin(pose.yaw_rad);
  return {pose.x_m + 0.1 * (cosine * velocity.forward_m_per_s - sine * velocity.left_m_per_s),
          pose.y_m + 0.1 * (sine * velocity.forward_m_per_s + cosine * velocity.left_m_per_s),
          pose.yaw_rad + 0.1 * velocity.yaw_rad_per_s};
}

TEST(SteerTo, ReachesAStopFromAnywhere) {
  const SteerOptions options;
  for (const PlanarPose& target : {PlanarPose{0.1, 0.0, 0.0}, PlanarPose{-0.5, 0.3, 1.0},
                                   PlanarPose{0.0, 0.0, -2.0}, PlanarPose{0.02, -0.4, 6.5}}) {
    PlanarPose present;
    int steps = 0;
    while (const std::optional<BaseVelocity> velocity = SteerTo(target, present, options)) {
      ASSERT_TRUE(velocity->yaw_rad_per_s == 0.0 ||
                  (velocity->forward_m_per_s == 0.0 && velocity->left_m_per_s == 0.0));
      present = Moved(present, *velocity);
      ASSERT_LT(++steps, 300);
    }
    EXPECT_LE(std::hypot(present.x_m - target.x_m, present.y_m - target.y_m), 0.021);
    EXPECT_LE(std::abs(present.yaw_rad - target.yaw_rad), 0.036);
  }
}

TEST(SteerTo, KeepsItsSpeedsWithinBounds) {
  const SteerOptions options;
  const auto far = SteerTo({10.0, 0.0, 0.0}, {}, options);
  EXPECT_DOUBLE_EQ(far->forward_m_per_s, options.max_speed_m_per_s);
  const auto near = SteerTo({0.0, 0.021, 0.0}, {}, options);
  EXPECT_NEAR(near->left_m_per_s, 0.042, 1e-9);
  EXPECT_FALSE(SteerTo({0.01, 0.01, 0.03}, {}, options));
}

TEST(SteerOptions, RefuseNoTolerance) {
  std::string error;
  SteerOptions options;
  EXPECT_TRUE(IsValid(options, &error));
  options.position_tolerance_m = 0.0;
  EXPECT_FALSE(IsValid(options, &error));
}

}  // namespace
}  // namespace rovio_sfm
