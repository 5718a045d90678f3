#include "rovio_sfm/merging/spread_gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

// The session with a scale that grows from frame to frame, as a monocular map drifts.
Session Drifted(const Session& truth, double growth) {
  Session session = truth;
  Rigid3 pose = truth.keyframes().begin()->second.cam_from_session;
  const Keyframe* before = nullptr;
  std::map<uint32_t, Sim3> drifted_from_true;
  double scale = 1.0;
  for (const auto& [index, frame] : truth.keyframes()) {
    if (before != nullptr) {
      Rigid3 step = frame.cam_from_session * Inverse(before->cam_from_session);
      step.translation *= scale;
      pose = step * pose;
      scale *= growth;
    }
    before = &frame;
    session.SetPose(index, pose);
    const Rigid3 session_from_cam = Inverse(pose);
    drifted_from_true[index] =
        Sim3{1.0, session_from_cam.rotation, session_from_cam.translation} *
        Sim3{scale, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()} *
        Sim3{1.0, frame.cam_from_session.rotation, frame.cam_from_session.translation};
  }
  for (const auto& [id, landmark] : truth.landmarks()) {
    const uint32_t frame = landmark.observations.front().frame;
    session.SetPosition(id, drifted_from_true.at(frame) * landmark.position);
  }
  return session;
}

Sim3 ToSim3(const Rigid3& rigid) { return {1.0, rigid.rotation, rigid.translation}; }

// What an overlap of the two frames measures, where the session's unit has grown by `scale`.
MergeReport LoopOf(const Session& drifted, const Session& truth, uint32_t first, uint32_t last,
                   double scale) {
  MergeReport loop;
  loop.kind = MergeKind::kLoop;
  loop.query_session = loop.other_session = drifted.id();
  loop.query = {drifted.drive(), last};
  loop.other = {drifted.drive(), first};
  const Sim3 last_from_first =
      Sim3{scale, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()} *
      ToSim3(truth.keyframe(last).cam_from_session *
             Inverse(truth.keyframe(first).cam_from_session));
  loop.query_from_other = Inverse(ToSim3(drifted.keyframe(last).cam_from_session)) *
                          last_from_first * ToSim3(drifted.keyframe(first).cam_from_session);
  return loop;
}

double Gap(const Session& session, const Session& truth, uint32_t first, uint32_t last) {
  const Rigid3 relative =
      session.keyframe(last).cam_from_session * Inverse(session.keyframe(first).cam_from_session);
  const Rigid3 expected =
      truth.keyframe(last).cam_from_session * Inverse(truth.keyframe(first).cam_from_session);
  return PoseDistance(relative, expected);
}

TEST(SpreadGap, ClosesALoopOverAllFrames) {
  const TwoDrives two = MakeTwoDrives();
  const Session truth = MappedSession(two, false, {});
  Session drifted = Drifted(truth, 1.002);
  const double before = Gap(drifted, truth, 0, 15);
  ASSERT_GT(before, 0.02);
  ASSERT_TRUE(SpreadGap({{&drifted, {}}}, LoopOf(drifted, truth, 0, 15, std::pow(1.002, 15)), {}));
  EXPECT_LT(Gap(drifted, truth, 0, 15), 0.2 * before);
  EXPECT_EQ(CheckInvariants(drifted), "");
  EXPECT_LT(PoseDistance(drifted.keyframe(0).cam_from_session, truth.keyframe(0).cam_from_session),
            1e-9);
}

TEST(SpreadGap, BendsALongWayByFewerNodes) {
  SyntheticDriveOptions options = TwoDrivesOptions();
  options.world.step *= options.world.num_cams / 700.0;
  options.world.turn_rad *= options.world.num_cams / 700.0;
  options.world.num_cams = 700;
  const TwoDrives two = MakeTwoDrives(options);
  const Session truth = MappedSession(two, false, {});
  Session drifted = Drifted(truth, 1.0001);
  const Session before = drifted;
  const double scale = std::pow(1.0001, 349);
  ASSERT_GT(Gap(before, truth, 0, 349), 0.02);
  ASSERT_TRUE(SpreadGap({{&drifted, {}}}, LoopOf(drifted, truth, 0, 349, scale), {}));
  EXPECT_LT(Gap(drifted, truth, 0, 349), 0.003 * Gap(before, truth, 0, 349));
  EXPECT_EQ(CheckInvariants(drifted), "");
  for (uint32_t i = 1; i < 350; ++i) {
    EXPECT_LT(Gap(drifted, before, i - 1, i), 0.0014) << "a step tears at frame " << i;
  }
}

TEST(SpreadGap, TakesALinkedSessionAlong) {
  const TwoDrives two = MakeTwoDrives();
  const Session truth = MappedSession(two, false, {});
  Session drifted = Drifted(truth, 1.002), linked = MappedSession(two, true, {});
  const auto links = LinksOf(TrueOverlap(two, 14, 14), drifted.id(), linked.id());
  const MergeReport loop = LoopOf(drifted, truth, 0, 15, std::pow(1.002, 15));
  const Rigid3 other = linked.keyframe(14).cam_from_session;
  const Rigid3 before = other * Inverse(drifted.keyframe(14).cam_from_session);
  ASSERT_TRUE(SpreadGap({{&drifted, {}}, {&linked, {}}}, loop, links));
  EXPECT_GT(PoseDistance(linked.keyframe(14).cam_from_session, other), 0.01);
  const Rigid3 after =
      linked.keyframe(14).cam_from_session * Inverse(drifted.keyframe(14).cam_from_session);
  EXPECT_LT(PoseDistance(after, before), 0.01);
}

TEST(SpreadGap, LeavesAClosedLoopAlone) {
  const TwoDrives two = MakeTwoDrives();
  const Session truth = MappedSession(two, false, {});
  Session session = truth;
  ASSERT_TRUE(SpreadGap({{&session, {}}}, LoopOf(session, truth, 0, 15, 1.0), {}));
  for (const auto& [index, frame] : session.keyframes()) {
    EXPECT_LT(PoseDistance(frame.cam_from_session, truth.keyframe(index).cam_from_session), 1e-6);
  }
}

TEST(SpreadGap, RefusesALoopThatCannotBe) {
  const TwoDrives two = MakeTwoDrives();
  const Session truth = MappedSession(two, false, {});
  Session session = truth;
  MergeReport wrong = LoopOf(session, truth, 0, 15, 1.0);
  wrong.query_from_other.translation += Eigen::Vector3d(30.0, 0.0, 10.0);
  EXPECT_FALSE(SpreadGap({{&session, {}}}, wrong, {}));
  EXPECT_EQ(BytesOf(session), BytesOf(truth));
}

}  // namespace
}  // namespace rovio_sfm
