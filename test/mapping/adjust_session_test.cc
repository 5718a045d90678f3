#include "rovio_sfm/mapping/adjust_session.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

// A tenth of the world's points is enough for adjustments that start near the truth.
SyntheticDrive MakeDrive(double noise_px = 0.0) {
  SyntheticDriveOptions options;
  options.world.noise_px = noise_px;
  options.world.num_points = 120;
  options.world.num_cams = 10;
  return MakeSyntheticDrive(options);
}

TEST(AdjustLocally, PullsADisturbedFrameBack) {
  const SyntheticDrive drive = MakeDrive();
  Session session = MappedDrive(drive);
  Rng rng(1);
  session.SetPose(9, PerturbPose(drive.world.cams_from_map[9], 0.002, 0.01, rng));
  MapperOptions options;
  options.adjust.local_frames = 3;  // the others are fixed
  options.adjust.running_max_iterations = 50;
  const PruneReport report = AdjustLocally(9, options, &session);
  EXPECT_LT(PoseDistance(session.keyframe(9).cam_from_session, drive.world.cams_from_map[9]), 1e-3);
  EXPECT_EQ(report.num_landmarks, 0u);
  EXPECT_LT(PoseDistance(session.keyframe(0).cam_from_session, drive.world.cams_from_map[0]),
            1e-12);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(AdjustLocally, PrunesAWrongLandmark) {
  const SyntheticDrive drive = MakeDrive();
  Session session = MappedDrive(drive);
  // A landmark of the observations of two points.
  const TrackId wrong = session.keyframe(9).tracks[0];
  session.RemoveLandmark(wrong);
  Keyframe frame = session.keyframe(9);
  frame.points[0] += Eigen::Vector2d(0.1, 0.1);
  session.RemoveKeyframe(9);
  session.AddKeyframe(9, frame);
  session.AddLandmark(wrong, drive.world.points[wrong - 1], {}, session.tracks().at(wrong).members);
  for (size_t i = 1; i < frame.tracks.size(); ++i) {
    if (session.FindLandmark(frame.tracks[i]) == nullptr) continue;
    session.AddObservation(frame.tracks[i], {9, static_cast<uint32_t>(i)});
  }
  const PruneReport report = AdjustLocally(9, {}, &session);
  EXPECT_GE(report.num_observations, 1u);
  EXPECT_EQ(session.keyframe(9).observed[0], 0);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(AdjustFinally, RecoversTheWorldAndCompletesIt) {
  const SyntheticDrive drive = MakeDrive();
  Session session = MappedDrive(drive);
  const size_t num_landmarks = session.landmarks().size();
  for (int i = 0; i < 20; ++i) session.RemoveLandmark(session.landmarks().begin()->first);
  Disturb(0.001, 0.005, &session);
  AdjustFinally({}, &session);
  EXPECT_EQ(CheckInvariants(session), "");
  EXPECT_GT(session.landmarks().size(), num_landmarks - 20);
  const auto error = MeasureTrajectory(session.Snapshot(), drive.world);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->num_frames, 10u);
  EXPECT_LT(error->max_distance, 1e-4);
}

TEST(AdjustFinally, StaysNearTheTruthWithNoise) {
  const SyntheticDrive drive = MakeDrive(1.0);
  Session session = MappedDrive(drive);
  Disturb(0.001, 0.005, &session);
  AdjustFinally({}, &session);
  const auto error = MeasureTrajectory(session.Snapshot(), drive.world);
  ASSERT_TRUE(error);
  EXPECT_LT(error->max_distance, 0.05);
  EXPECT_LT(error->max_rotation_rad, 0.02);
}

TEST(AdjustFinally, BearsAnEmptySession) {
  Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
  const PruneReport report = AdjustFinally({}, &session);
  EXPECT_EQ(report.num_observations, 0u);
}

std::string AdjustGlobally(int num_threads) {
  Session session = MappedDrive(MakeDrive(0.5));
  Disturb(0.001, 0.005, &session);
  Executor executor(num_threads);
  GlobalAdjustment global({}, &executor, ResultTiming::kFixed);
  global.MaybeStart(session);
  EXPECT_FALSE(global.Advance(&session));
  EXPECT_TRUE(global.Advance(&session));
  EXPECT_EQ(CheckInvariants(session), "");
  return BytesOf(session);
}

TEST(GlobalAdjustment, GivesTheSameBytesWithAndWithoutThreads) {
  const std::string alone = AdjustGlobally(0);
  EXPECT_EQ(AdjustGlobally(1), alone);
  Session untouched = MappedDrive(MakeDrive(0.5));
  Disturb(0.001, 0.005, &untouched);
  EXPECT_NE(BytesOf(untouched), alone);
}

// The drive at its true poses and points, one in `every` features of the frames from `first` on
// shifted to the right.
Session WithOutliers(const SyntheticDrive& drive, uint32_t first, size_t every, double shift,
                     const MapperOptions& options) {
  Session session({1}, drive.events[0].id.drive, drive.world.camera);
  for (uint32_t i = 0; i < drive.events.size(); ++i) {
    Keyframe frame = MakeKeyframe(drive.events[i], drive.world.cams_from_map[i], options);
    const size_t end = i < first ? 0 : frame.points.size();
    for (size_t k = 0; k < end; k += every) frame.points[k].x() += shift;
    session.AddKeyframe(i, frame);
  }
  for (const auto& [id, track] : session.tracks()) {
    if (track.members.size() < 2) continue;
    session.AddLandmark(id, drive.world.points[id - 1], {}, track.members);
  }
  return session;
}

double GreatestDistance(const Session& session, const SyntheticDrive& drive) {
  const auto error = MeasureTrajectory(session.Snapshot(), drive.world);
  return error ? error->max_distance : HUGE_VAL;
}

// Nearly all shifted features are near enough to stay, and would bend a map of squared errors.
TEST(AdjustFinally, IsNotBentByErrorsTooSmallToPrune) {
  const SyntheticDrive drive = MakeDrive(0.5);
  Session session = WithOutliers(drive, 5, 4, 3.0 / drive.world.camera.MeanFocal(), {});
  const size_t num_before = MakeGlobalBundle(session).problem.observations.size();
  AdjustFinally({}, &session);
  const double error = GreatestDistance(session, drive);
  SessionBundle bundle = MakeGlobalBundle(session);
  EXPECT_GE(bundle.problem.observations.size(), num_before - 5);
  ASSERT_TRUE(AdjustBundle(&bundle.problem, {50, 0.0, 1e-8}).usable);
  ApplyBundle(bundle, true, &session);
  EXPECT_LT(error, 0.8 * GreatestDistance(session, drive));
}

// The map of a drive with outliers where a feature's position has this sigma.
Session AdjustedWithSigma(double pixel_sigma_px) {
  MapperOptions options;
  options.pixel_sigma_px = pixel_sigma_px;
  Session session = WithOutliers(MakeDrive(0.5), 0, 10, 0.01, options);
  Executor executor(0);
  GlobalAdjustment global(options, &executor, ResultTiming::kFixed);
  global.MaybeStart(session);
  global.Advance(&session);
  EXPECT_TRUE(global.Advance(&session));
  return session;
}

TEST(GlobalAdjustment, MeasuresItsLossInPixels) {
  const Session one = AdjustedWithSigma(1.0), four = AdjustedWithSigma(4.0);
  for (const auto& [index, frame] : one.keyframes()) {
    const Rigid3& other = four.keyframe(index).cam_from_session;
    EXPECT_LT(PoseDistance(frame.cam_from_session, other), 1e-6) << index;
  }
}

TEST(GlobalAdjustment, WaitsForGrowth) {
  const SyntheticDrive drive = MakeDrive();
  Executor executor(0);
  GlobalAdjustment global({}, &executor, ResultTiming::kFixed);
  Session small = MappedDrive(drive, 5);
  global.MaybeStart(small);
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(global.Advance(&small));
  Session session = MappedDrive(drive, 8);
  for (const bool grown : {true, false}) {
    global.MaybeStart(session);
    EXPECT_FALSE(global.Advance(&session));
    EXPECT_EQ(global.Advance(&session), grown);
  }
  for (const size_t num_frames : {9, 10}) {
    session = MappedDrive(drive, num_frames);
    global.MaybeStart(session);
    global.Advance(&session);
    EXPECT_EQ(global.Advance(&session), num_frames == 10) << num_frames;
  }
}

// The session after a global adjustment or the final one with so many iterations.
std::string BytesAfter(int max_iterations, bool is_final) {
  Session session = MappedDrive(MakeDrive(0.5));
  Disturb(0.005, 0.05, &session);
  MapperOptions options;
  (is_final ? options.adjust.final_max_iterations : options.adjust.running_max_iterations) =
      max_iterations;
  if (is_final) {
    AdjustFinally(options, &session);
    return BytesOf(session);
  }
  Executor executor(0);
  GlobalAdjustment global(options, &executor, ResultTiming::kFixed);
  global.MaybeStart(session);
  while (!global.Advance(&session)) continue;
  return BytesOf(session);
}

TEST(GlobalAdjustment, StopsAfterTheIterationsAllowed) {
  for (const bool is_final : {false, true}) {
    const std::string one = BytesAfter(1, is_final), two = BytesAfter(2, is_final);
    EXPECT_NE(one, two) << is_final;
    EXPECT_NE(two, BytesAfter(20, is_final)) << is_final;
  }
}

TEST(GlobalAdjustment, ForgetsWhatIsAbandoned) {
  Session session = MappedDrive(MakeDrive());
  Executor executor(1);
  GlobalAdjustment global({}, &executor, ResultTiming::kFixed);
  global.MaybeStart(session);
  global.Abandon();
  global.Abandon();
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(global.Advance(&session));
}

}  // namespace
}  // namespace rovio_sfm
