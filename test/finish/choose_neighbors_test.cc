#include "rovio_sfm/finish/choose_neighbors.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"
#include "rovio_sfm/geometry/sim3.h"

namespace rovio_sfm {
namespace {

TEST(ChooseNeighbors, RangeHoldsWhatTheImageSees) {
  const auto surroundings = ChooseNeighbors(SmallRoom(), {});
  ASSERT_EQ(surroundings.size(), 5u);
  EXPECT_LT(surroundings[0].near, 1.6);
  EXPECT_GT(surroundings[0].near, 1.0);
  EXPECT_GT(surroundings[0].far, 4.0);
  EXPECT_LT(surroundings[0].far, 6.0);
}

TEST(ChooseNeighbors, PrefersTheAngleThatServesBest) {
  MapModel model = SmallRoom(3);
  // The second stands beside the first by 0.2 m, the third by 0.8 m: 3 and 12 degrees at 4 m.
  for (const auto& [image, y] : {std::pair{1u, 0.2}, {2u, 0.8}}) {
    model.images[image].cam_from_map = TransformCamera(
        Sim3{1.0, Eigen::Quaterniond::Identity(), {0.0, y, 0.0}}, model.images[0].cam_from_map);
  }
  NeighborOptions options;
  options.best_angle_rad = 0.2;
  options.max_neighbors = 1;
  EXPECT_EQ(ChooseNeighbors(model, options)[0].neighbors, std::vector<uint32_t>{2});
  options.best_angle_rad = 0.05;
  EXPECT_EQ(ChooseNeighbors(model, options)[0].neighbors, std::vector<uint32_t>{1});
}

TEST(ChooseNeighbors, NoneWithoutCommonPointsOrParallax) {
  MapModel model = SmallRoom(2);
  model.images[1].cam_from_map = model.images[0].cam_from_map;
  EXPECT_TRUE(ChooseNeighbors(model, {})[0].neighbors.empty());
  model.points.clear();
  const auto surroundings = ChooseNeighbors(model, {});
  EXPECT_TRUE(surroundings[0].neighbors.empty());
  EXPECT_EQ(surroundings[0].near, 0.0);
}

}  // namespace
}  // namespace rovio_sfm
