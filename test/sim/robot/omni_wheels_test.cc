#include "rovio_sfm/sim/robot/omni_wheels.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(RimTravel, IsTheHubsMotionAlongTheWheel) {
  const OmniGeometry geometry;
  const auto forward = RimTravel({1.0, 0.0, 0.0}, geometry);
  EXPECT_NEAR(forward[kLeftWheel], 0.8660, 1e-4);
  EXPECT_NEAR(forward[kRightWheel], 0.8660, 1e-4);
  EXPECT_NEAR(forward[kRearWheel], 0.0, 1e-12);
  const auto left = RimTravel({0.0, 1.0, 0.0}, geometry);
  EXPECT_NEAR(left[kLeftWheel], -0.5, 1e-9);
  EXPECT_NEAR(left[kRightWheel], 0.5, 1e-9);
  EXPECT_NEAR(left[kRearWheel], 1.0, 1e-9);
}

TEST(MotionFromRim, InvertsRimTravel) {
  const OmniGeometry geometry;
  const BodyMotion motion = MotionFromRim(RimTravel({0.3, -0.2, 0.7}, geometry), geometry);
  EXPECT_NEAR(motion.forward_m, 0.3, 1e-12);
  EXPECT_NEAR(motion.left_m, -0.2, 1e-12);
  EXPECT_NEAR(motion.turn_rad, 0.7, 1e-12);
}

TEST(TickCounter, CarriesFractionsOver) {
  TickCounter counter({}, 0.0, Rng(1));
  int total = 0;
  for (int i = 0; i < 1000; ++i) total += counter.Add({0.001, 0.0, 0.0})[0];
  EXPECT_NEAR(total, 465, 1);
}

TEST(TickCounter, LosesTheAskedShare) {
  TickCounter counter({}, 0.2, Rng(1));
  const int counted = counter.Add({100.0, 0.0, -100.0})[2];
  EXPECT_NEAR(counted, -0.8 * 46500, 500);
}

TEST(TickIntegrator, DrivesACircleHome) {
  const OmniGeometry geometry;
  TickCounter counter(geometry, 0.0, Rng(1));
  TickIntegrator integrator(geometry);
  for (int i = 0; i < 360; ++i) {
    integrator.Add(counter.Add(RimTravel({0.02, 0.0, M_PI / 180.0}, geometry)));
  }
  EXPECT_NEAR(integrator.pose()[2], 2.0 * M_PI, 0.05);
  EXPECT_LT(integrator.pose().head<2>().norm(), 0.1);
  EXPECT_GT(integrator.covariance()(0, 0), 0.0);
}

TEST(DrawSlip, StaysWithinItsOptions) {
  Rng rng(4);
  for (int i = 0; i < 100; ++i) {
    const Slip slip = DrawSlip({}, rng);
    EXPECT_NEAR(slip.forward_gain, 1.0, 0.05);
    EXPECT_NEAR(slip.side_gain, 0.775, 0.0751);
  }
}

TEST(SlipOptions, RefusesMoreLossThanMost) {
  SlipOptions options;
  options.min_side_loss = 0.4;
  EXPECT_FALSE(options.IsValid(nullptr));
}

}  // namespace
}  // namespace rovio_sfm::sim
