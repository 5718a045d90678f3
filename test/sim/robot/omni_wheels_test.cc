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
