#include "rovio_sfm/sfm/session_bundle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {
namespace {

SyntheticWorld MakeWorld() {
  SyntheticOptions options;
  options.num_points = 200;
  options.num_cams = 8;
  options.step = 0.4;
  return MakeSyntheticWorld(options);
}

// A correction of the whole gauge.
Rigid3 AnyCorrection() {
  return {Eigen::Quaterniond(0.9, 0.1, -0.2, 0.1).normalized(), {0.5, -0.2, 0.1}};
}

// The bundle as an adjustment that moves everything by new_from_old would leave it.
void Correct(const Rigid3& new_from_old, SessionBundle* bundle) {
  for (BundleCamera& camera : bundle->problem.cameras) {
    camera.cam_from_map = camera.cam_from_map * Inverse(new_from_old);
  }
  for (Eigen::Vector3d& point : bundle->problem.points) point = new_from_old * point;
}

void ExpectMovedMap(const Rigid3& new_from_old, const SyntheticWorld& world,
                    const Session& session) {
  for (const auto& [index, frame] : session.keyframes()) {
    const Rigid3 expected = world.cams_from_map[index] * Inverse(new_from_old);
    EXPECT_LT(PoseDistance(frame.cam_from_session, expected), 1e-7) << "frame " << index;
  }
  for (const auto& [id, landmark] : session.landmarks()) {
    const Eigen::Vector3d expected = new_from_old * world.points[id - 1];
    EXPECT_LT((landmark.position - expected).norm(), 1e-9) << "landmark " << id;
  }
}

// How many landmarks both frames see, by counting all.
size_t NumShared(const Session& session, uint32_t a, uint32_t b) {
  size_t count = 0;
  for (const auto& [id, landmark] : session.landmarks()) {
    size_t num_seen = 0;
    for (const Observation& o : landmark.observations) num_seen += o.frame == a || o.frame == b;
    count += num_seen == 2 ? 1 : 0;
  }
  return count;
}

TEST(CovisibleFrames, RanksByTheNumberOfSharedLandmarks) {
  const Session session = MakeMappedSession(MakeWorld());
  const auto frames = CovisibleFrames(session, 3, 8, 1);
  ASSERT_EQ(frames.size(), 8u);
  EXPECT_EQ(frames[0], 3u);
  for (size_t i = 2; i < 8; ++i) {
    EXPECT_GE(NumShared(session, 3, frames[i - 1]), NumShared(session, 3, frames[i]));
  }
  const auto few = CovisibleFrames(session, 3, 3, 1);
  EXPECT_EQ(few, (std::vector<uint32_t>{3, frames[1], frames[2]}));
  EXPECT_EQ(CovisibleFrames(session, 3, 4, 100000), std::vector<uint32_t>{3});
  EXPECT_EQ(CovisibleFrames(session, 3, 1, 1), std::vector<uint32_t>{3});
}

TEST(MakeLocalBundle, FixesTheFramesAround) {
  const Session session = MakeMappedSession(MakeWorld());
  const SessionBundle bundle = MakeLocalBundle(session, {3, 4}, 3);
  ASSERT_EQ(bundle.frames.size(), 5u);
  EXPECT_EQ(bundle.frames[0], 3u);
  EXPECT_FALSE(bundle.problem.cameras[0].fixed || bundle.problem.cameras[1].fixed);
  for (size_t i = 2; i < 5; ++i) EXPECT_TRUE(bundle.problem.cameras[i].fixed);
  for (const TrackId id : bundle.tracks) {
    const auto& observations = session.landmarks().at(id).observations;
    EXPECT_TRUE(std::any_of(observations.begin(), observations.end(),
                            [](const Observation& o) { return o.frame == 3 || o.frame == 4; }));
  }
  EXPECT_EQ(bundle.tracks.size(), bundle.problem.points.size());
}

TEST(MakeGlobalBundle, HoldsEverythingThatIsNotWeak) {
  Session session = MakeMappedSession(MakeWorld());
  session.SetWeak(5, true);
  const SessionBundle bundle = MakeGlobalBundle(session);
  EXPECT_EQ(bundle.frames, (std::vector<uint32_t>{0, 1, 2, 3, 4, 6, 7}));
  EXPECT_EQ(bundle.tracks.size(), session.landmarks().size());
  for (const BundleObservation& observation : bundle.problem.observations) {
    const auto& camera = bundle.problem.cameras[observation.camera];
    const Eigen::Vector3d x = camera.cam_from_map * bundle.problem.points[observation.point];
    EXPECT_LT((x.hnormalized() - observation.x_normalized).norm(), 1e-9);
  }
}

TEST(MakeGlobalBundle, DropsObservationsBehindTheirCamera) {
  Session session = MakeMappedSession(MakeWorld());
  const TrackId id = session.landmarks().begin()->first;
  session.SetPosition(id, {0, 0, -5});
  const SessionBundle bundle = MakeGlobalBundle(session);
  EXPECT_EQ(std::count(bundle.tracks.begin(), bundle.tracks.end(), id), 0);
}

TEST(MakeGlobalBundle, IsEmptyForAnEmptySession) {
  const SessionBundle bundle = MakeGlobalBundle(Session({1}, {"rovio", 1, 0}, {}));
  EXPECT_TRUE(bundle.frames.empty() && bundle.tracks.empty());
  Session session({1}, {"rovio", 1, 0}, {});
  ApplyBundle(bundle, true, &session);
  EXPECT_TRUE(session.keyframes().empty());
}

TEST(ApplyBundle, MovesFramesAndLandmarksBornSinceWithTheirReference) {
  const SyntheticWorld world = MakeWorld();
  Session session = MakeMappedSession(world);
  const Session complete = session;
  session.RemoveKeyframe(7);
  session.RemoveKeyframe(6);
  for (int i = 0; i < 30; ++i) session.RemoveLandmark(session.landmarks().begin()->first);
  SessionBundle bundle = MakeGlobalBundle(session);
  session = complete;  // two frames and thirty landmarks are new
  Correct(AnyCorrection(), &bundle);
  ApplyBundle(bundle, true, &session);
  ExpectMovedMap(AnyCorrection(), world, session);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(ApplyBundle, LightFramesMoveWithTheirReference) {
  const SyntheticWorld world = MakeWorld();
  Session session = MakeMappedSession(world);
  LightFrame light;
  light.reference = 3;
  light.cam_from_reference.translation = {0.1, 0.0, 0.0};
  session.AddLightFrame(100, light);
  SessionBundle bundle = MakeGlobalBundle(session);
  Correct(AnyCorrection(), &bundle);
  ApplyBundle(bundle, true, &session);
  const auto blocks = session.Snapshot().frames;
  const Rigid3 expected = light.cam_from_reference * session.keyframe(3).cam_from_session;
  EXPECT_LT(PoseDistance(blocks.back()->back().cam_from_session, expected), 1e-7);
}

TEST(ApplyBundle, ALocalBundleLeavesTheOthersWhereTheyAre) {
  const SyntheticWorld world = MakeWorld();
  Session session = MakeMappedSession(world);
  SessionBundle bundle = MakeLocalBundle(session, {6, 7}, 0);
  Correct(AnyCorrection(), &bundle);
  ApplyBundle(bundle, false, &session);
  EXPECT_LT(PoseDistance(session.keyframe(0).cam_from_session, world.cams_from_map[0]), 1e-12);
  EXPECT_GT(PoseDistance(session.keyframe(7).cam_from_session, world.cams_from_map[7]), 0.1);
}

TEST(ApplyBundle, SkipsWhatIsGone) {
  const SyntheticWorld world = MakeWorld();
  Session session = MakeMappedSession(world);
  SessionBundle bundle = MakeGlobalBundle(session);
  Correct(AnyCorrection(), &bundle);
  session.RemoveLandmark(session.landmarks().begin()->first);
  session.RemoveKeyframe(4);
  ApplyBundle(bundle, true, &session);
  EXPECT_EQ(session.keyframes().count(4), 0u);
  ExpectMovedMap(AnyCorrection(), world, session);
  EXPECT_EQ(CheckInvariants(session), "");
}

}  // namespace
}  // namespace rovio_sfm
