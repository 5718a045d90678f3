#include "rovio_sfm/report/level_map.h"

#include <gtest/gtest.h>

#include "report/small_snapshot.h"

namespace rovio_sfm {
namespace {

MapSnapshot TwoMaps() {
  MapSnapshot snapshot;
  snapshot.sessions = {SmallSession(1, 3, {}), SmallSession(2, 5, {SmallLandmark(1, 4, 0.001)})};
  return snapshot;
}

TEST(FindLargestMap, TakesTheOneWithMostRegisteredImages) {
  const auto map = FindLargestMap(TwoMaps());
  ASSERT_TRUE(map.has_value());
  EXPECT_EQ(map->id.value, 2u);
  EXPECT_FALSE(FindLargestMap({}).has_value());
}

TEST(FindLevelMap, AnswersNothingForAnUnknownMap) {
  EXPECT_TRUE(FindLevelMap(TwoMaps(), {1}).has_value());
  EXPECT_FALSE(FindLevelMap(TwoMaps(), {7}).has_value());
}

TEST(PosedImages, LeavesOutWeakOnesAndLooksForward) {
  const auto images = PosedImages(*FindLargestMap(TwoMaps()));
  ASSERT_EQ(images.size(), 4u);
  EXPECT_EQ(images[3].id.index, 3u);
  const Rigid3& last = images[3].level_from_camera.reference_from_body;
  const Eigen::Vector3d moved =
      last.translation - images[0].level_from_camera.reference_from_body.translation;
  EXPECT_LT((moved - Eigen::Vector3d(0.0, -1.5, 0.0)).norm(), 1e-9) << moved.transpose();
  EXPECT_LT((last.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-9);
}

TEST(PosedImages, AreMetricWithAScale) {
  MapSnapshot snapshot = TwoMaps();
  snapshot.sessions[1].scale = MapScale{2.0, 0.01, "odometry"};
  const auto images = PosedImages(*FindLargestMap(snapshot));
  const Eigen::Vector3d moved = images[3].level_from_camera.reference_from_body.translation -
                                images[0].level_from_camera.reference_from_body.translation;
  EXPECT_NEAR(moved.norm(), 3.0, 1e-9);
}

TEST(IsCounted, AppliesAllThreeGates) {
  LandmarkSnapshot landmark = SmallLandmark(1, 2, 0.001);
  EXPECT_TRUE(IsCounted(landmark));
  landmark.num_views = 1;
  EXPECT_FALSE(IsCounted(landmark));
  landmark = SmallLandmark(1, 2, 0.009);  // 4.5 px
  EXPECT_FALSE(IsCounted(landmark));
  landmark = SmallLandmark(1, 2, 0.001);
  landmark.max_parallax_rad = 0.02;
  EXPECT_FALSE(IsCounted(landmark));
}

// Two sessions of one map, four landmarks each, of which some are one point.
MapSnapshot SharingMap() {
  const LandmarkBlock landmarks = {SmallLandmark(1, 2, 0.001), SmallLandmark(2, 3, 0.002),
                                   SmallLandmark(3, 4, 0.001), SmallLandmark(4, 2, 0.001)};
  MapSnapshot snapshot;
  snapshot.sessions = {SmallSession(1, 5, landmarks), SmallSession(2, 5, landmarks)};
  snapshot.sessions[1].map = {1};
  snapshot.shared_landmarks[{1}] =
      std::make_shared<const SharedLandmarks>(SharedLandmarks{{{{1}, 2}, 5},
                                                              {{{1}, 4}, 5},
                                                              {{{2}, 3}, 5},
                                                              {{{1}, 1}, 6},
                                                              {{{2}, 77}, 6},
                                                              {{{9}, 1}, 7},
                                                              {{{2}, 1}, 7}});
  return snapshot;
}

TEST(UniteLandmarks, GivesAPointTheViewsOfAllItsLandmarks) {
  const LevelMap map = *FindLargestMap(SharingMap());
  const std::vector<MapLandmark> landmarks = UniteLandmarks(map);
  ASSERT_EQ(landmarks.size(), 6u);  // of eight: the other points' partners are not there
  const LandmarkSnapshot& united = landmarks[1].landmark;
  EXPECT_EQ(landmarks[1].session, &map.sessions[0]);
  EXPECT_EQ(united.id, 2u);
  EXPECT_EQ(united.num_views, 9u);
  EXPECT_NEAR(united.mean_error_px, (3 * 1.0 + 2 * 0.5 + 4 * 0.5) / 9.0, 1e-12);
  EXPECT_NEAR(united.squared_error_normalized, 3 * 4e-6 + 6 * 1e-6, 1e-15);
  EXPECT_EQ(LevelCloud(map).size(), 6u);
}

TEST(UniteLandmarks, GivesAllWhereNothingIsShared) {
  MapSnapshot snapshot = SharingMap();
  snapshot.shared_landmarks.clear();
  EXPECT_EQ(UniteLandmarks(*FindLargestMap(snapshot)).size(), 8u);
}

TEST(LevelCloud, LiesInFrontOfTheCameras) {
  const auto cloud = LevelCloud(*FindLargestMap(TwoMaps()));
  ASSERT_EQ(cloud.size(), 1u);
  EXPECT_LT((cloud[0].x_in_map - Eigen::Vector3d(2.0, -0.1, 0.0)).norm(), 1e-9)
      << cloud[0].x_in_map.transpose();
  EXPECT_EQ(cloud[0].session, 2u);
}

}  // namespace
}  // namespace rovio_sfm
