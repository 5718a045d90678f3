#include "rovio_sfm/dense/fuse_depths.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

std::vector<DepthMap> Constant(const std::vector<DepthView>& views, float depth) {
  std::vector<DepthMap> depths;
  for (const DepthView& view : views) {
    depths.push_back(DepthMap(view.grey.size(), CV_32F, cv::Scalar(depth)));
  }
  return depths;
}

TEST(FuseDepths, PointsLieOnTheWallAndFaceTheCameras) {
  const auto views = ViewsOfWall(2.0);
  const PointCloud cloud = FuseDepths(views, Constant(views, 2.0f), {});
  EXPECT_GT(cloud.size(), 3000u);
  for (const DensePoint& point : cloud) {
    EXPECT_NEAR(point.position.z(), 2.0, 1e-4);
    EXPECT_LT(point.normal.z(), -0.99f);
    EXPECT_GE(point.num_views, 2u);
  }
}

TEST(FuseDepths, CarvesWhatViewsLookThrough) {
  const auto views = ViewsOfWall(2.0);
  auto depths = Constant(views, 2.0f);
  // Two views believe in something that floats at half the way; three see the wall behind it.
  for (const size_t liar : {0u, 1u}) {
    cv::rectangle(depths[liar], {60, 50, 30, 20}, cv::Scalar(1.0f), cv::FILLED);
  }
  for (const DensePoint& point : FuseDepths(views, depths, {})) {
    EXPECT_GT(point.position.z(), 1.5f);
  }
}

TEST(FuseDepths, OneViewAloneTellsNothing) {
  const auto views = ViewsOfWall(2.0);
  auto depths = Constant(views, 0.0f);
  depths[0].setTo(2.0f);
  EXPECT_TRUE(FuseDepths(views, depths, {}).empty());
}

}  // namespace
}  // namespace rovio_sfm
