#include "rovio_sfm/mapping/weak_pose.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

SyntheticDrive DriveWithOdometry() {
  SyntheticDriveOptions options;
  options.world.motion = SyntheticMotion::kForward;
  options.world.turn_rad = 0.0;
  options.metres_per_unit = 0.5;
  return MakeSyntheticDrive(options);
}

TEST(PredictWeakPose, TakesTheLastBaselineWithoutOdometry) {
  const SyntheticDrive drive = MakeSyntheticDrive({});  // equal steps: the guess is the truth
  const auto pose = PredictWeakPose(drive.events[6], PosedDrive(drive, 6));
  ASSERT_TRUE(pose);
  EXPECT_LT(PoseDistance(*pose, drive.world.cams_from_map[6]), 1e-7);
}

TEST(PredictWeakPose, TakesTheBaselineOfTheOdometryWhereThereIsAScale) {
  const SyntheticDrive drive = DriveWithOdometry();
  FrameEvent event = drive.events[6];
  Session session = PosedDrive(drive, 6);
  session.SetPose(4, drive.world.cams_from_map[0]);  // a last step of another length
  EXPECT_GT(PoseDistance(*PredictWeakPose(event, session), drive.world.cams_from_map[6]), 0.5);
  session.set_scale(MapScale{0.5, 0.05, "odometry"});
  EXPECT_LT(PoseDistance(*PredictWeakPose(event, session), drive.world.cams_from_map[6]), 1e-2);
  event.odometry.reset();
  EXPECT_GT(PoseDistance(*PredictWeakPose(event, session), drive.world.cams_from_map[6]), 0.5);
}

TEST(PredictWeakPose, TakesTheBaselineOfTheOdometryInAnyDirection) {
  const SyntheticDrive drive = DriveWithOdometry();
  Session session({1}, drive.events[0].id.drive, drive.world.camera);
  FrameEvent event;
  for (uint32_t i = 0; i <= 6; ++i) {
    event = drive.events[i];
    std::swap(event.odometry->x_m, event.odometry->y_m);  // the robot drives along y
    const Rigid3& pose = drive.world.cams_from_map[i == 4 ? 0 : i];
    if (i < 6) session.AddKeyframe(i, MakeKeyframe(event, pose, {}));
  }
  session.set_scale(MapScale{0.5, 0.05, "odometry"});
  EXPECT_LT(PoseDistance(*PredictWeakPose(event, session), drive.world.cams_from_map[6]), 1e-2);
}

TEST(PredictWeakPose, PassesOverFailedPairsAndUnknownFrames) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  FrameEvent event = drive.events[6];
  PairMatches failed = event.pairs[0], unknown = event.pairs[0];
  failed.verdict = PairVerdict::kFailed;
  failed.cam_from_other = {};
  unknown.other_index = 77;
  event.pairs.insert(event.pairs.begin(), {failed, unknown});
  const auto pose = PredictWeakPose(event, PosedDrive(drive, 6));
  ASSERT_TRUE(pose);
  EXPECT_LT(PoseDistance(*pose, drive.world.cams_from_map[6]), 1e-7);
}

TEST(PredictWeakPose, FollowsARotationOnTheSpot) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  FrameEvent event = drive.events[6];
  event.pairs[0].verdict = PairVerdict::kRotation;
  event.pairs[0].cam_from_other.translation.setZero();
  const auto pose = PredictWeakPose(event, PosedDrive(drive, 6));
  ASSERT_TRUE(pose);
  EXPECT_LT((OriginInA(*pose) - OriginInA(drive.world.cams_from_map[5])).norm(), 1e-9);
}

TEST(PredictWeakPose, AnswersNothingWithoutAPairOrAStep) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  FrameEvent event = drive.events[6];
  EXPECT_FALSE(PredictWeakPose(event, PosedDrive(drive, 3)));  // its partner is not in the session
  event.pairs.clear();
  EXPECT_FALSE(PredictWeakPose(event, PosedDrive(drive, 6)));
  EXPECT_FALSE(PredictWeakPose(drive.events[1], PosedDrive(drive, 1)));  // no step before
}

TEST(ResectWeakFrame, PosesItFromItsLandmarks) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  Session session = MappedDrive(drive, 6);
  session.AddKeyframe(6, MakeKeyframe(drive.events[6], {}, {}));
  session.SetWeak(6, true);
  ASSERT_TRUE(ResectWeakFrame(6, {}, &session));
  EXPECT_FALSE(session.keyframe(6).weak);
  EXPECT_LT(PoseDistance(session.keyframe(6).cam_from_session, drive.world.cams_from_map[6]), 1e-7);
}

TEST(ResectWeakFrame, LeavesOneWithoutLandmarksAndOneThatIsGone) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  Session session = PosedDrive(drive, 7);
  session.SetWeak(6, true);
  EXPECT_FALSE(ResectWeakFrame(6, {}, &session));
  EXPECT_TRUE(session.keyframe(6).weak);
  EXPECT_FALSE(ResectWeakFrame(7, {}, &session));
}

}  // namespace
}  // namespace rovio_sfm
