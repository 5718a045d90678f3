#include "rovio_sfm/dense/fuse_depths.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

std::vector<DepthMap> Constant(const std::vector<DepthView>& views, float depth) {
  std::vector<DepthMap> depths;
  for (const DepthView& view : views) {
    depths.push_back(Constant(view, depth));
  }
  return depths;
}

std::vector<cv::Mat> AllTell(const std::vector<DepthView>& views) {
  std::vector<cv::Mat> telling;
  for (const DepthView& view : views) {
    telling.push_back(cv::Mat(view.grey.size(), CV_8U, cv::Scalar(255)));
  }
  return telling;
}

TEST(FuseDepths, PointsLieOnTheWallAndFaceTheCameras) {
  const auto views = ViewsOfWall(2.0);
  const PointCloud cloud = FuseDepths(views, Constant(views, 2.0f), AllTell(views), {});
  EXPECT_GT(cloud.size(), 3000u);
  size_t num_facing = 0;  // all but those on the pictures' last columns and rows
  for (const DensePoint& point : cloud) {
    EXPECT_NEAR(point.position.z(), 2.0, 1e-4);
    if (point.normal.isZero()) continue;
    EXPECT_LT(point.normal.z(), -0.99f);
    ++num_facing;
  }
  EXPECT_GT(num_facing, 0.98 * static_cast<double>(cloud.size()));
}

TEST(FuseDepths, CarvesWhatViewsLookThrough) {
  const auto views = ViewsOfWall(2.0);
  auto depths = Constant(views, 2.0f);
  // Two views believe in something that floats at half the way; three see the wall behind it.
  for (const size_t liar : {0u, 1u}) {
    cv::rectangle(depths[liar], {60, 50, 30, 20}, cv::Scalar(1.0f), cv::FILLED);
  }
  for (const DensePoint& point : FuseDepths(views, depths, AllTell(views), {})) {
    EXPECT_GT(point.position.z(), 1.5f);
  }
}

TEST(FuseDepths, OnlyTellingPixelsGivePointsButAllCarve) {
  const auto views = ViewsOfWall(2.0);
  auto depths = Constant(views, 2.0f);
  auto telling = AllTell(views);
  for (size_t i = 1; i < views.size(); ++i) telling[i].setTo(0);
  cv::rectangle(depths[0], {60, 50, 30, 20}, cv::Scalar(1.0f), cv::FILLED);
  const PointCloud cloud = FuseDepths(views, depths, telling, {});
  EXPECT_GT(cloud.size(), 1000u);
  for (const DensePoint& point : cloud) {
    EXPECT_EQ(point.num_views, 1u);
    EXPECT_GT(point.position.z(), 1.5f);
  }
}

TEST(FuseDepths, TellsHowManyViewsFoundAPoint) {
  const auto views = ViewsOfWall(2.0);
  auto depths = Constant(views, 0.0f);
  depths[0].setTo(2.0f);
  for (const DensePoint& point : FuseDepths(views, depths, AllTell(views), {}))
    EXPECT_EQ(point.num_views, 1u);
  depths[1].setTo(2.0f);
  const PointCloud cloud = FuseDepths(views, depths, AllTell(views), {});
  const auto is_found_twice = [](const DensePoint& point) { return point.num_views == 2; };
  EXPECT_GT(std::count_if(cloud.begin(), cloud.end(), is_found_twice),
            static_cast<std::ptrdiff_t>(cloud.size() / 2));
}

}  // namespace
}  // namespace rovio_sfm
