#include "rovio_sfm/finish/choose_neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>

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
  EXPECT_GT(surroundings[0].far, 2.0 * surroundings[0].typical);
  EXPECT_LT(surroundings[0].far, 15.0);
  EXPECT_GT(surroundings[0].typical, 1.6);
  EXPECT_LT(surroundings[0].typical, 4.0);
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

// Ten cameras that drive along a passage, of which those ahead no longer see the walls beside.
MapModel Passage() {
  MapModel model = SmallRoom(10);
  const ModelPoint pattern = model.points[0];
  for (double x = 0.5; x < 4.0; x += 0.1) {
    for (const double y : {-0.5, 0.5}) {
      model.points.push_back(pattern);
      model.points.back().x_in_map = {x, y, 0.2};
    }
  }
  return model;
}

bool Shows(const MapModel& model, uint32_t image, const Eigen::Vector3d& x_in_map) {
  const Eigen::Vector3d x = model.images[image].cam_from_map * x_in_map;
  const Camera& camera = model.cameras[0];
  const Eigen::Vector2d pixel(camera.fx * x.x() / x.z() + camera.cx,
                              camera.fy * x.y() / x.z() + camera.cy);
  return x.z() > 0.0 && pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() < camera.width &&
         pixel.y() < camera.height;
}

TEST(ChooseNeighbors, SeeTogetherAllThatTheImageSees) {
  const MapModel model = Passage();
  NeighborOptions options;
  options.max_neighbors = 3;
  const std::vector<uint32_t> neighbors = ChooseNeighbors(model, options)[4].neighbors;
  ASSERT_EQ(neighbors.size(), 3u);
  size_t num_shown = 0, num_seen_by_two = 0;
  for (const ModelPoint& point : model.points) {
    if (!Shows(model, 4, point.x_in_map)) continue;
    ++num_shown;
    const auto sees = [&](uint32_t other) { return Shows(model, other, point.x_in_map); };
    if (std::count_if(neighbors.begin(), neighbors.end(), sees) >= 2) ++num_seen_by_two;
  }
  EXPECT_GT(num_shown, 100u);
  EXPECT_EQ(num_seen_by_two, num_shown);
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
