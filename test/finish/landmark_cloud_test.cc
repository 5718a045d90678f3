#include "rovio_sfm/finish/landmark_cloud.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

TEST(LandmarkCloud, HasThePointsWithNormalsTowardsTheCameras) {
  MapModel model = SmallRoom();
  model.points[0].color = {1, 2, 3};
  const PointCloud cloud = LandmarkCloud(model);
  ASSERT_EQ(cloud.size(), model.points.size());
  EXPECT_EQ(cloud[0].position, model.points[0].x_in_map.cast<float>());
  EXPECT_EQ(cloud[0].color, (Rgb{1, 2, 3}));
  EXPECT_EQ(cloud[0].num_views, 5u);
  EXPECT_LT(cloud[0].normal.x(), -0.9f);  // of the wall
  EXPECT_NEAR(cloud[0].normal.norm(), 1.0f, 1e-6f);
}

TEST(LandmarkCloud, OfNothingIsEmpty) { EXPECT_TRUE(LandmarkCloud(MapModel()).empty()); }

}  // namespace
}  // namespace rovio_sfm
