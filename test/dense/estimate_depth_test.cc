#include "rovio_sfm/dense/estimate_depth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

TEST(EstimateDepth, FindsAWall) {
  const auto views = ViewsOfWall(2.5);
  const DepthMap depth = EstimateDepth(views[0], NeighborsOf(views, 0), {});
  const int known = cv::countNonZero(depth);
  EXPECT_GT(known, 0.5 * static_cast<double>(depth.total()));
  int right = 0;
  for (const float z : cv::Mat_<float>(depth)) right += std::abs(z / 2.5f - 1.0f) < 0.01f ? 1 : 0;
  EXPECT_GT(right, 0.99 * known);
}

TEST(EstimateDepth, KnowsNothingOfAPlainWall) {
  std::vector<DepthView> views;
  for (const double x : {0.0, 0.2, -0.2}) views.push_back(ViewOfWall(x, 0.0, 2.5, 1));
  const DepthMap depth = EstimateDepth(views[0], {&views[1], &views[2]}, {});
  EXPECT_EQ(cv::countNonZero(depth), 0);
}

TEST(EstimateDepth, FindsLittleOfWhatLiesOutsideItsRange) {
  auto views = ViewsOfWall(2.5);
  views[0].near = 3.0, views[0].far = 6.0;
  const DepthMap depth = EstimateDepth(views[0], NeighborsOf(views, 0), {});
  // What chance finds, the other views do not confirm.
  EXPECT_LT(cv::countNonZero(depth), 0.2 * static_cast<double>(depth.total()));
}

TEST(EstimateDepth, NeedsTwoNeighbours) {
  const auto views = ViewsOfWall(2.5);
  EXPECT_EQ(cv::countNonZero(EstimateDepth(views[0], {&views[1]}, {})), 0);
}

}  // namespace
}  // namespace rovio_sfm
