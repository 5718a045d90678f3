#include "rovio_sfm/sim/tour/find_overlaps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/sim/world/render_image.h"
#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kStep_px = 2;

class Overlaps : public testing::Test {
 protected:
  DepthView ViewAt(double x_m, double y_m, double yaw_rad) const {
    Eigen::Matrix3d level;
    level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
    const Rigid3 pose{turn * Eigen::Quaterniond(level), {x_m, y_m, 0.28}};
    return {pose, RenderDepth(world_, SmallCamera(), pose, kStep_px)};
  }

  const World world_{SmallWorldSpec()};
};

TEST_F(Overlaps, AViewSharesAllWithItself) {
  const DepthView view = ViewAt(0.6, 1.5, 0.0);
  EXPECT_GT(CovisibleShare(SmallCamera(), view, view, kStep_px), 0.98);
}

TEST_F(Overlaps, ATurnedViewSharesLess) {
  const DepthView view = ViewAt(0.6, 1.5, 0.0), turned = ViewAt(0.6, 1.5, 0.4);
  const double share = CovisibleShare(SmallCamera(), view, turned, kStep_px);
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.7);
}

TEST_F(Overlaps, FlowsAreThoseOfATurn) {
  const DepthView view = ViewAt(0.6, 1.5, 0.0), turned = ViewAt(0.6, 1.5, 0.1);
  EXPECT_NEAR(FlowsBetween(SmallCamera(), view, view, kStep_px).back(), 0.0, 1e-9);
  const std::vector<double> flows_px = FlowsBetween(SmallCamera(), view, turned, kStep_px);
  EXPECT_NEAR(flows_px.front(), 70.0 * std::tan(0.1), 0.3);  // in the middle, where it is least
}

TEST_F(Overlaps, OppositeViewsArePairsOfNothing) {
  EXPECT_TRUE(
      FindOverlaps(SmallCamera(), {ViewAt(1, 1.5, 0), ViewAt(1, 1.5, M_PI)}, kStep_px).empty());
}

TEST_F(Overlaps, ListsPairsOfOneAndOfTwoLists) {
  const std::vector<DepthView> views = {ViewAt(0.6, 1.5, 0.0), ViewAt(0.7, 1.5, 0.1)};
  const auto own = FindOverlaps(SmallCamera(), views, kStep_px);
  ASSERT_EQ(own.size(), 1u);
  EXPECT_EQ(own[0].first, 0);
  EXPECT_EQ(own[0].second, 1);
  EXPECT_NEAR(own[0].angle_rad, 0.1, 1e-6);
  EXPECT_EQ(FindOverlaps(SmallCamera(), views, views, kStep_px).size(), 4u);
}

TEST_F(Overlaps, WhatIsHiddenIsNotShared) {
  // From beside the crate at (2, 1) the wall behind it is seen; from in front of it, it is hidden.
  const DepthView before = ViewAt(1.3, 1.0, 0.0), beside = ViewAt(1.3, 1.5, 0.0);
  EXPECT_LT(CovisibleShare(SmallCamera(), beside, before, kStep_px), 0.75);
}

}  // namespace
}  // namespace rovio_sfm::sim
