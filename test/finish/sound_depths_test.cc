#include "rovio_sfm/finish/sound_depths.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

// A point of two views at the place of an old one, its distance from the first camera scaled.
void AddTwin(size_t of, double factor, MapModel* model) {
  ModelPoint twin = model->points[of];
  twin.views.resize(2);
  const Eigen::Vector3d center = OriginInA(model->images[0].cam_from_map);
  twin.x_in_map = center + factor * (twin.x_in_map - center);
  model->points.push_back(twin);
}

TEST(SoundDepths, SpanTheNeighboursWithRoom) {
  const MapModel model = SmallRoom(3);
  const Keypoint& wall = model.images[0].keypoints[25];  // all round it lies on the wall
  const DepthRange range = SoundDepths(model, 0, {}).Around(0, wall.x_normalized);
  EXPECT_NEAR(range.near, 4.0 / 1.1, 1e-9);
  EXPECT_NEAR(range.far, 4.0 * 1.1, 1e-9);
}

TEST(SoundDepths, KnowNothingFromTooFewOrUnsoundPoints) {
  MapModel model = SmallRoom(2);
  EXPECT_EQ(SoundDepths(model, 0, {}).Around(0, {0.0, 0.0}).far, 0.0);
  EXPECT_GT(SoundDepths(model, 5, {}).Around(0, {0.0, 0.0}).far, 0.0);
  EXPECT_EQ(SoundDepths(model, 5, {}).Around(0, {0.0, 0.0}, 2).far, 0.0);
}

TEST(RemoveInconsistentDepths, DropsWhatLiesBeforeOrBehindItsSurroundings) {
  MapModel model = SmallRoom(3);
  const size_t count = model.points.size();
  AddTwin(25, 0.7, &model);
  AddTwin(25, 1.0, &model);
  AddTwin(25, 1.5, &model);
  const Eigen::Vector3d sound = model.points[count + 1].x_in_map;
  EXPECT_EQ(RemoveInconsistentDepths(count, {}, &model), 2u);
  ASSERT_EQ(model.points.size(), count + 1);
  EXPECT_EQ(model.points.back().x_in_map, sound);
}

TEST(RemoveInconsistentDepths, KeepsTrustedPoints) {
  MapModel model = SmallRoom(3);
  AddTwin(25, 0.7, &model);
  EXPECT_EQ(RemoveInconsistentDepths(model.points.size(), {}, &model), 0u);
}

TEST(RemoveInconsistentDepths, KeepsWhatHasTooFewNeighbours) {
  MapModel model = SmallRoom(3);
  model.points.resize(4);
  AddTwin(0, 0.5, &model);
  EXPECT_EQ(RemoveInconsistentDepths(4, {}, &model), 0u);
}

}  // namespace
}  // namespace rovio_sfm
