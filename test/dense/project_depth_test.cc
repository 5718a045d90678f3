#include "rovio_sfm/dense/project_depth.h"

#include <gtest/gtest.h>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

TEST(ProjectDepth, ThereAndBack) {
  DepthView view = ViewOfWall(0.3, -0.1, 2.0);
  view.cam_from_map.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized());
  const Eigen::Vector3d x = PointOfPixel(view, {40.25, 17.5}, 1.75);
  const auto seen = SeePoint(view, x);
  ASSERT_TRUE(seen);
  EXPECT_NEAR((seen->x_px - Eigen::Vector2d(40.25, 17.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(seen->depth, 1.75, 1e-12);
  EXPECT_EQ(seen->pixel, cv::Point(40, 18));
}

TEST(TransferPixels, IsTheWayOverThePoint) {
  const DepthView from = ViewOfWall(0.0, 0.0, 2.0);
  DepthView to = ViewOfWall(0.3, -0.1, 2.0);
  to.cam_from_map.rotation = Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 3).normalized());
  const Eigen::Vector2d x_px(70.5, 44.0);
  const auto seen = SeePoint(to, PointOfPixel(from, x_px, 1.75));
  ASSERT_TRUE(seen);
  const Eigen::Vector3d transferred = TransferPixels(to, from)(x_px, 1.75);
  EXPECT_NEAR(transferred.z(), seen->depth, 1e-12);
  const auto place = PlaceInPicture(transferred, to.grey.size());
  ASSERT_TRUE(place);
  EXPECT_NEAR((*place - seen->x_px).norm(), 0.0, 1e-9);
}

TEST(SeePoint, NothingBehindOrBeside) {
  const DepthView view = ViewOfWall(0.0, 0.0, 2.0);
  EXPECT_FALSE(SeePoint(view, {0.0, 0.0, -1.0}));
  EXPECT_FALSE(SeePoint(view, {5.0, 0.0, 1.0}));
  EXPECT_TRUE(SeePoint(view, {0.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace rovio_sfm
