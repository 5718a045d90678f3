#include "rovio_sfm/dense/check_depth.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"
#include "rovio_sfm/dense/estimate_depth.h"

namespace rovio_sfm {
namespace {

TEST(KeepAgreed, KeepsWhatTwoOthersHaveFound) {
  const auto views = ViewsOfWall(2.0);
  const DepthMap right = Constant(views[0], 2.0f), wrong = Constant(views[0], 2.2f);
  const std::vector<const DepthView*> others = {&views[1], &views[2], &views[3]};
  const cv::Rect middle(40, 30, 80, 60);
  const auto count = [&](const DepthMap& mine, const std::vector<const DepthMap*>& theirs) {
    return cv::countNonZero(KeepAgreed(views[0], mine, others, theirs, {}).depth(middle));
  };
  EXPECT_EQ(count(right, {&right, &wrong, &right}), middle.area());
  EXPECT_EQ(count(right, {&right, &wrong, &wrong}), 0);
  EXPECT_EQ(count(wrong, {&right, &right, &right}), 0);
}

TEST(KeepAgreed, UnknownDepthsConfirmNothing) {
  const auto views = ViewsOfWall(2.0);
  const DepthMap right = Constant(views[0], 2.0f), unknown = Constant(views[0], 0.0f);
  const std::vector<const DepthView*> others = {&views[1], &views[2]};
  EXPECT_EQ(cv::countNonZero(KeepAgreed(views[0], right, others, {&right, &unknown}, {}).depth), 0);
}

TEST(KeepAgreed, DropsWhatTheSweepFindsByChance) {
  auto views = ViewsOfWall(2.5);
  for (DepthView& view : views) view.near = 3.0, view.far = 6.0;
  std::vector<DepthMap> depths;
  for (size_t i = 0; i < views.size(); ++i) {
    depths.push_back(EstimateDepth(views[i], NeighborsOf(views, i), {}));
  }
  std::vector<const DepthMap*> theirs;
  for (const uint32_t other : views[0].neighbors) theirs.push_back(&depths[other]);
  const MeasuredDepth agreed = KeepAgreed(views[0], depths[0], NeighborsOf(views, 0), theirs, {});
  EXPECT_LT(cv::countNonZero(agreed.depth), 0.05 * static_cast<double>(agreed.depth.total()));
}

TEST(KeepAgreed, ViewsFromNearlyTheSameDirectionConfirmNothing) {
  std::vector<DepthView> views;
  for (const double x : {0.0, 0.02, -0.02, 0.2}) views.push_back(ViewOfWall(x, 0.0, 2.0));
  const DepthMap right = Constant(views[0], 2.0f);
  const auto count = [&](const DepthView& other) {
    return cv::countNonZero(
        KeepAgreed(views[0], right, {&views[1], &other}, {&right, &right}, {}).depth);
  };
  EXPECT_EQ(count(views[2]), 0);
  EXPECT_GT(count(views[3]), 0);
}

TEST(KeepAgreed, TellsTheMeanAndItsError) {
  const auto views = ViewsOfWall(2.0);
  const DepthMap mine = Constant(views[0], 2.03f), theirs = Constant(views[0], 2.0f);
  const std::vector<const DepthView*> others = {&views[1], &views[2], &views[3], &views[4]};
  const MeasuredDepth agreed =
      KeepAgreed(views[0], mine, others, {&theirs, &theirs, &theirs, &theirs}, {});
  const cv::Point middle(80, 60);
  // Weights are by the distance squared.
  const double mine_weight = 1.0 / (2.03 * 2.03), their_weight = 4.0 / (2.0 * 2.0);
  EXPECT_NEAR(agreed.depth.at<float>(middle),
              (2.03 * mine_weight + 2.0 * their_weight) / (mine_weight + their_weight), 1e-4);
  // Four views from aside by b = 0.2 m: each moves it by (z^2 + b^2) / (f b) a pixel.
  const double focal_px = views[0].pixel_from_ray(0, 0);
  EXPECT_NEAR(agreed.sigma.at<float>(middle), (2.03 * 2.03 + 0.04) / (focal_px * 0.2) / 2.0, 4e-4);
}

}  // namespace
}  // namespace rovio_sfm
