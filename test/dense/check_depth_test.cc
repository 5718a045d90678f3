#include "rovio_sfm/dense/check_depth.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

DepthMap Constant(const DepthView& view, float depth) {
  return DepthMap(view.grey.size(), CV_32F, cv::Scalar(depth));
}

TEST(KeepAgreed, KeepsWhatTwoOthersHaveFound) {
  const auto views = ViewsOfWall(2.0);
  const DepthMap right = Constant(views[0], 2.0f), wrong = Constant(views[0], 2.2f);
  const std::vector<const DepthView*> others = {&views[1], &views[2], &views[3]};
  const cv::Rect middle(40, 30, 80, 60);
  EXPECT_EQ(
      cv::countNonZero(KeepAgreed(views[0], right, others, {&right, &wrong, &right}, {})(middle)),
      middle.area());
  EXPECT_EQ(
      cv::countNonZero(KeepAgreed(views[0], right, others, {&right, &wrong, &wrong}, {})(middle)),
      0);
  EXPECT_EQ(cv::countNonZero(KeepAgreed(views[0], wrong, others, {&right, &right, &right}, {})), 0);
}

TEST(KeepAgreed, UnknownDepthsConfirmNothing) {
  const auto views = ViewsOfWall(2.0);
  const DepthMap right = Constant(views[0], 2.0f), unknown = Constant(views[0], 0.0f);
  const std::vector<const DepthView*> others = {&views[1], &views[2]};
  EXPECT_EQ(cv::countNonZero(KeepAgreed(views[0], right, others, {&right, &unknown}, {})), 0);
}

TEST(KeepAgreed, ViewsFromNearlyTheSameDirectionConfirmNothing) {
  std::vector<DepthView> views;
  for (const double x : {0.0, 0.04, -0.04, 0.2}) views.push_back(ViewOfWall(x, 0.0, 2.0));
  const DepthMap right = Constant(views[0], 2.0f);
  const std::vector<const DepthMap*> found = {&right, &right};
  EXPECT_EQ(cv::countNonZero(KeepAgreed(views[0], right, {&views[1], &views[2]}, found, {})), 0);
  EXPECT_GT(cv::countNonZero(KeepAgreed(views[0], right, {&views[1], &views[3]}, found, {})), 0);
}

}  // namespace
}  // namespace rovio_sfm
