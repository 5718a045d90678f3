#include "rovio_sfm/sfm/triangulate_tracks.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld MakeWorld(double noise_px, SyntheticMotion motion = SyntheticMotion::kCircle) {
  SyntheticOptions options;
  options.num_points = 120;
  options.num_cams = 5;
  options.motion = motion;
  options.step = 0.4;
  options.noise_px = noise_px;
  return MakeSyntheticWorld(options);
}

std::vector<PointView> ViewsOf(const SyntheticWorld& world, uint32_t point) {
  std::vector<PointView> views;
  for (size_t cam = 0; cam < world.views.size(); ++cam) {
    for (const SyntheticView& view : world.views[cam]) {
      if (view.point != point) continue;
      views.push_back(
          {world.cams_from_map[cam], view.x_normalized, 1.0 / world.camera.MeanFocal()});
    }
  }
  return views;
}

// A point that all cameras see.
uint32_t PointSeenByAll(const SyntheticWorld& world) {
  uint32_t point = 0;
  while (ViewsOf(world, point).size() < world.views.size()) ++point;
  return point;
}

TEST(TriangulatePoint, RecoversTheExactPoint) {
  const SyntheticWorld world = MakeWorld(0.0);
  const uint32_t index = PointSeenByAll(world);
  const auto point = TriangulatePoint(ViewsOf(world, index), {});
  ASSERT_TRUE(point);
  EXPECT_LT((point->position - world.points[index]).norm(), 1e-9);
  EXPECT_EQ(point->inliers.size(), world.views.size());
}

TEST(TriangulatePoint, ABadViewCostsTheViewNotThePoint) {
  const SyntheticWorld world = MakeWorld(0.0);
  const uint32_t index = PointSeenByAll(world);
  for (size_t bad = 0; bad < world.views.size(); ++bad) {
    auto views = ViewsOf(world, index);
    views[bad].x_normalized += Eigen::Vector2d(0.1, 0.1);
    const auto point = TriangulatePoint(views, {});
    ASSERT_TRUE(point) << bad;
    EXPECT_LT((point->position - world.points[index]).norm(), 1e-9) << bad;
    EXPECT_EQ(point->inliers.size(), views.size() - 1) << bad;
    for (const uint32_t i : point->inliers) EXPECT_NE(i, bad);
  }
}

TEST(TriangulatePoint, StaysNearTheTruthWithNoise) {
  const SyntheticWorld world = MakeWorld(1.0);
  const uint32_t index = PointSeenByAll(world);
  const auto point = TriangulatePoint(ViewsOf(world, index), {});
  ASSERT_TRUE(point);
  EXPECT_LT((point->position - world.points[index]).norm(), 0.1);
}

TEST(TriangulatePoint, RefusesTooFewViewsAndTooLittleParallax) {
  const SyntheticWorld world = MakeWorld(0.0);
  auto views = ViewsOf(world, PointSeenByAll(world));
  EXPECT_FALSE(TriangulatePoint({}, {}));
  EXPECT_FALSE(TriangulatePoint({views[0]}, {}));
  EXPECT_FALSE(TriangulatePoint({views[0], views[0]}, {}));
  EXPECT_FALSE(TriangulatePoint(views, {3.0, 3.0}));
}

TEST(TriangulatePoint, RefusesRaysThatMeetBehindOrMiss) {
  std::vector<PointView> views(2);
  views[1].cam_from_map.translation = {-1.0, 0.0, 0.0};
  views[0].sigma = views[1].sigma = 0.001;
  views[0].x_normalized = {-0.2, 0.0}, views[1].x_normalized = {0.2, 0.0};
  EXPECT_FALSE(TriangulatePoint(views, {}));  // behind
  views[0].x_normalized = {0.2, 0.2}, views[1].x_normalized = {-0.2, -0.2};
  EXPECT_FALSE(TriangulatePoint(views, {}));  // askew
}

TEST(TriangulateTracks, MakesTheTrueMap) {
  const SyntheticWorld world = MakeWorld(0.0);
  Session session = MakeSyntheticSession(world);
  uint32_t num_created = 0;
  for (uint32_t frame = 0; frame < 5; ++frame) {
    num_created += TriangulateTracks(frame, {}, &session).num_created;
    ASSERT_EQ(CheckInvariants(session), "");
  }
  EXPECT_EQ(num_created, session.landmarks().size());
  EXPECT_GT(num_created, 60u);
  for (const auto& [id, landmark] : session.landmarks()) {
    EXPECT_LT((landmark.position - world.points[id - 1]).norm(), 1e-6);
    EXPECT_EQ(landmark.observations, session.tracks().at(id).members);
  }
}

TEST(TriangulateTracks, TakesTheColourOfTheFirstView) {
  const SyntheticWorld world = MakeWorld(0.0);
  Session session = MakeSyntheticSession(world);
  TriangulateTracks(4, {}, &session);
  ASSERT_FALSE(session.landmarks().empty());
  for (const auto& [id, landmark] : session.landmarks()) {
    EXPECT_EQ(landmark.color[0], (id - 1) % 256);
  }
}

TEST(TriangulateTracks, MakesNothingFromRotationAlone) {
  Session session = MakeSyntheticSession(MakeWorld(0.0, SyntheticMotion::kRotation));
  EXPECT_EQ(TriangulateTracks(4, {}, &session).num_created, 0u);
}

TEST(TriangulateTracks, LeavesWeakFramesOut) {
  const SyntheticWorld world = MakeWorld(0.0);
  Session session = MakeSyntheticSession(world);
  session.SetWeak(2, true);
  TriangulateTracks(4, {}, &session);
  ASSERT_FALSE(session.landmarks().empty());
  EXPECT_EQ(session.keyframe(2).num_observed, 0u);
  for (const uint32_t frame : {0u, 1u, 3u}) session.SetWeak(frame, true);
  Session alone = MakeSyntheticSession(world);
  for (const uint32_t frame : {0u, 1u, 2u, 3u}) alone.SetWeak(frame, true);
  EXPECT_EQ(TriangulateTracks(4, {}, &alone).num_created, 0u);
}

TEST(CompleteLandmarks, AddsTheMembersThatAgreeAndNoOthers) {
  const SyntheticWorld world = MakeWorld(0.0);
  Session session = MakeSyntheticSession(world);
  TriangulateTracks(4, {}, &session);
  Keyframe moved = session.keyframe(4);
  session.RemoveKeyframe(4);
  EXPECT_EQ(CompleteLandmarks(3, 3.0, &session), 0u);
  moved.points[0] += Eigen::Vector2d(0.1, 0.0);
  session.AddKeyframe(4, moved);
  uint32_t num_with_landmark = 0;
  for (const TrackId id : moved.tracks) {
    num_with_landmark += session.FindLandmark(id) != nullptr ? 1 : 0;
  }
  const bool first_has = session.FindLandmark(moved.tracks[0]) != nullptr;
  EXPECT_EQ(CompleteLandmarks(4, 3.0, &session), num_with_landmark - (first_has ? 1 : 0));
  EXPECT_EQ(session.keyframe(4).observed[0], 0);
  EXPECT_EQ(CheckInvariants(session), "");
}

}  // namespace
}  // namespace rovio_sfm
