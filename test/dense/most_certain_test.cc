#include "rovio_sfm/dense/most_certain.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

// Two views of one wall, from 4 m and from 2 m.
struct FarAndNear {
  std::vector<DepthView> views = {ViewOfWall(0.0, 0.0, 4.0), ViewOfWall(0.0, 0.0, 2.0)};
  MeasuredDepth of_far = {Constant(views[0], 4.0f), Constant(views[0], 0.08f)};
  MeasuredDepth of_near = {Constant(views[1], 2.0f), Constant(views[1], 0.02f)};
  FarAndNear() { views[1].cam_from_map.translation.z() = -2.0; }

  int CountOfFar() const {
    return cv::countNonZero(
        FindMostCertain(views[0], of_far, {&views[1]}, {&of_near}, {})(kSeenByBoth));
  }
  int CountOfNear() const {
    return cv::countNonZero(
        FindMostCertain(views[1], of_near, {&views[0]}, {&of_far}, {})(kSeenByBoth));
  }

  const cv::Rect kSeenByBoth{50, 40, 60, 40};
};

TEST(FindMostCertain, WhoIsNearTells) {
  const FarAndNear both;
  EXPECT_EQ(both.CountOfFar(), 0);
  EXPECT_EQ(both.CountOfNear(), both.kSeenByBoth.area());
}

TEST(FindMostCertain, KeepsWhatOthersDoNotKnowOrSeeElsewhere) {
  FarAndNear both;
  both.of_near.depth.setTo(0.0f);
  EXPECT_EQ(both.CountOfFar(), both.kSeenByBoth.area());
  both.of_near.depth.setTo(1.5f);  // half a metre before the wall: something else
  EXPECT_EQ(both.CountOfFar(), both.kSeenByBoth.area());
}

TEST(FindMostCertain, ThoseWhoKnowAsMuchKeepBoth) {
  FarAndNear both;
  both.of_near.sigma.setTo(0.08f);
  EXPECT_EQ(both.CountOfFar(), both.kSeenByBoth.area());
  EXPECT_EQ(both.CountOfNear(), both.kSeenByBoth.area());
}

}  // namespace
}  // namespace rovio_sfm
