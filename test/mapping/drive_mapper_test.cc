#include "rovio_sfm/mapping/drive_mapper.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

// Maps a synthetic drive and keeps what the mapper said.
struct DriveRun {
  explicit DriveRun(const SyntheticDriveOptions& drive_options, const MapperOptions& options = {})
      : drive(MakeSyntheticDrive(drive_options)),
        mapper(Context(options), drive.events[0].id.drive, drive.world.camera) {}

  void AddAll() {
    for (const FrameEvent& event : drive.events) {
      outcomes.push_back(mapper.Add(event).outcome);
      for (const auto& [id, session] : table.all()) ASSERT_EQ(CheckInvariants(*session), "");
    }
    mapper.Finish();
    for (const auto& [id, session] : table.all()) ASSERT_EQ(CheckInvariants(*session), "");
  }

  void ExpectTrajectory(size_t session, size_t num_frames, double max_distance) {
    ASSERT_LT(session, table.all().size());
    const auto error = MeasureTrajectory(session_at(session).Snapshot(), drive.world);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->num_frames, num_frames);
    EXPECT_LT(error->max_distance, max_distance);
  }

  const Session& session_at(size_t number) const {
    return *table.Find({static_cast<uint32_t>(number) + 1});
  }

  MapperContext Context(const MapperOptions& options) {
    MapperContext context;
    context.options = options;
    context.store = &store;
    context.sessions = &table;
    context.executor = &executor;
    context.on_session_closed = [](Session*) {};
    return context;
  }

  SyntheticDrive drive;
  MemoryFrameStore store;
  SessionTable table;
  Executor executor{0};
  DriveMapper mapper;
  std::vector<MapperOutcome> outcomes;
};

TEST(DriveMapper, RecoversAnExactDrive) {
  DriveRun run({});
  run.AddAll();
  ASSERT_EQ(run.table.all().size(), 1u);
  EXPECT_EQ(run.session_at(0).state(), SessionState::kFinished);
  EXPECT_FALSE(run.session_at(0).scale().has_value());
  run.ExpectTrajectory(0, 16, 1e-4);
  EXPECT_EQ(run.outcomes.front(), MapperOutcome::kHeld);
  EXPECT_EQ(run.outcomes.back(), MapperOutcome::kKeyframe);
  EXPECT_GT(run.mapper.counters().global_adjustments, 0u);
}

// Alone it would be pulled off what it is linked with.
TEST(DriveMapper, LeavesALinkedSessionToTheAdjustmentOfItsMap) {
  SyntheticDriveOptions options;
  options.world.noise_px = 1.0;
  DriveRun run(options);
  MapperContext context = run.Context({});
  context.is_linked = [](SessionId) { return true; };
  DriveMapper mapper(context, run.drive.events[0].id.drive, run.drive.world.camera);
  for (const FrameEvent& event : run.drive.events) mapper.Add(event);
  const auto before = run.table.FindNewest(run.drive.events[0].id.drive)->keyframes();
  mapper.Finish();
  for (const auto& [index, frame] :
       run.table.FindNewest(run.drive.events[0].id.drive)->keyframes()) {
    EXPECT_EQ(PoseDistance(frame.cam_from_session, before.at(index).cam_from_session), 0.0);
  }
  EXPECT_EQ(mapper.counters().global_adjustments, 0u);
}

TEST(DriveMapper, StaysNearTheTruthWithNoiseAndCutTracks) {
  SyntheticDriveOptions options;
  options.world.noise_px = 1.0;
  options.track_length = 6;
  options.with_links = true;
  DriveRun run(options);
  run.AddAll();
  run.ExpectTrajectory(0, 16, 0.05);
}

TEST(DriveMapper, StaysNearTheTruthWhereTheMapIsAdjustedByWindows) {
  SyntheticDriveOptions options;
  options.world.noise_px = 1.0;
  options.world.num_cams = 40;
  MapperOptions windows;
  windows.adjust.max_global_frames = 10;
  DriveRun run(options, windows);
  run.AddAll();
  run.ExpectTrajectory(0, 40, 0.05);
}

TEST(DriveMapper, PosesLightFrames) {
  SyntheticDriveOptions options;
  options.light_frames = 1;
  options.world.num_cams = 19;
  options.world.step = 0.2;
  DriveRun run(options);
  run.AddAll();
  ASSERT_EQ(run.table.all().size(), 1u);
  EXPECT_EQ(run.session_at(0).light_frames().size(), 9u);
  run.ExpectTrajectory(0, 19, 1e-4);
  EXPECT_EQ(run.outcomes[1], MapperOutcome::kUnposed);
  EXPECT_EQ(run.outcomes[17], MapperOutcome::kLight);
}

TEST(DriveMapper, TakesAWeakFrameInOnceItsTracksAreLinked) {
  SyntheticDriveOptions options;
  options.blind = {11};
  options.with_late_links = true;
  DriveRun run(options);
  run.AddAll();
  EXPECT_EQ(run.outcomes[11], MapperOutcome::kWeak);
  EXPECT_EQ(run.outcomes[12], MapperOutcome::kKeyframe);
  ASSERT_EQ(run.table.all().size(), 1u);
  EXPECT_FALSE(run.session_at(0).keyframe(11).weak);
  run.ExpectTrajectory(0, 16, 1e-4);
}

TEST(DriveMapper, TriesAWeakFrameAgainAfterEachLaterOne) {
  SyntheticDriveOptions options;
  options.blind = {11};
  options.with_late_links = true;
  DriveRun run(options);
  std::swap(run.drive.events[12].links, run.drive.events[15].links);
  run.AddAll();
  EXPECT_EQ(run.outcomes[11], MapperOutcome::kWeak);
  EXPECT_FALSE(run.session_at(0).keyframe(11).weak);
  run.ExpectTrajectory(0, 16, 1e-4);

  MapperOptions few_tries;
  few_tries.max_weak_tries = 2;
  DriveRun dropped(options, few_tries);
  std::swap(dropped.drive.events[12].links, dropped.drive.events[15].links);
  dropped.AddAll();
  EXPECT_EQ(dropped.session_at(0).keyframes().count(11), 0u);
}

TEST(DriveMapper, DropsAWeakFrameThatStaysWeak) {
  SyntheticDriveOptions options;
  options.blind = {11};
  DriveRun run(options);
  run.AddAll();
  EXPECT_EQ(run.outcomes[11], MapperOutcome::kWeak);
  ASSERT_EQ(run.table.all().size(), 1u);
  EXPECT_EQ(run.session_at(0).keyframes().count(11), 0u);
  EXPECT_EQ(run.mapper.counters().weak_frames, 1u);
  run.ExpectTrajectory(0, 15, 1e-4);
}

TEST(DriveMapper, LosesTheSessionAfterTooManyWeakFramesAndStartsTheNext) {
  SyntheticDriveOptions options;
  options.blind = {9, 10, 11, 12};
  options.world.num_cams = 22;
  DriveRun run(options);
  run.AddAll();
  EXPECT_EQ(run.mapper.counters().lost_sessions, 1u);
  ASSERT_EQ(run.table.all().size(), 2u);
  EXPECT_EQ(run.session_at(0).state(), SessionState::kLost);
  EXPECT_EQ(run.session_at(1).state(), SessionState::kFinished);
  run.ExpectTrajectory(0, 9, 1e-4);
  run.ExpectTrajectory(1, 9, 1e-4);
}

TEST(DriveMapper, BearsAsManyWeakFramesInARowAsAllowed) {
  SyntheticDriveOptions options;
  options.blind = {10, 11};
  options.world.num_cams = 18;
  for (const int max_weak_frames : {2, 1}) {
    MapperOptions mapper_options;
    mapper_options.max_weak_frames = max_weak_frames;
    DriveRun run(options, mapper_options);
    run.AddAll();
    EXPECT_EQ(run.mapper.counters().lost_sessions, max_weak_frames == 2 ? 0u : 1u);
  }
}

TEST(DriveMapper, LosesTheSessionWhereNoPairReachesBack) {
  SyntheticDriveOptions options;
  options.cut = 9;
  options.world.num_cams = 18;
  DriveRun run(options);
  run.AddAll();
  EXPECT_EQ(run.outcomes[9], MapperOutcome::kHeld);
  ASSERT_EQ(run.table.all().size(), 2u);
  run.ExpectTrajectory(0, 9, 1e-4);
  run.ExpectTrajectory(1, 9, 1e-4);  // the frame at which it was lost is not
}

TEST(DriveMapper, ReportsTheScaleOfTheOdometry) {
  SyntheticDriveOptions options;
  options.metres_per_unit = 0.5;
  DriveRun run(options);
  run.AddAll();
  const Session& session = run.session_at(0);
  ASSERT_TRUE(session.scale().has_value());
  const double units = (OriginInA(session.keyframe(15).cam_from_session) -
                        OriginInA(session.keyframe(0).cam_from_session))
                           .norm();
  const double true_units =
      (OriginInA(run.drive.world.cams_from_map[15]) - OriginInA(run.drive.world.cams_from_map[0]))
          .norm();
  EXPECT_NEAR(session.scale()->metres_per_unit * units, 0.5 * true_units, 0.02 * true_units);
}

TEST(DriveMapper, StartsNoMapFromRotationOnTheSpot) {
  SyntheticDriveOptions options;
  options.world.motion = SyntheticMotion::kRotation;
  options.world.noise_px = 0.5;
  options.world.num_cams = 6;
  DriveRun run(options);
  run.AddAll();
  ASSERT_EQ(run.table.all().size(), 1u);
  EXPECT_TRUE(run.session_at(0).keyframes().empty());
  for (const MapperOutcome outcome : run.outcomes) EXPECT_EQ(outcome, MapperOutcome::kHeld);
}

TEST(DriveMapper, MapsAShortDriveAtItsEnd) {
  SyntheticDriveOptions options;
  options.world.num_cams = 4;  // below the wished angle, within the patience
  DriveRun run(options);
  run.AddAll();
  for (const MapperOutcome outcome : run.outcomes) EXPECT_EQ(outcome, MapperOutcome::kHeld);
  run.ExpectTrajectory(0, 4, 1e-4);
}

TEST(DriveMapper, GoesOnInAnotherSessionAfterFinish) {
  SyntheticDriveOptions options;
  options.world.num_cams = 18;
  DriveRun run(options);
  for (size_t i = 0; i < 9; ++i) run.mapper.Add(run.drive.events[i]);
  run.mapper.Finish();
  for (size_t i = 9; i < 18; ++i) run.mapper.Add(run.drive.events[i]);
  run.mapper.Finish();
  ASSERT_EQ(run.table.all().size(), 2u);
  run.ExpectTrajectory(0, 9, 1e-4);
  run.ExpectTrajectory(1, 9, 1e-4);
}

TEST(DriveMapper, ARefusedEventOpensNoSession) {
  DriveRun run({});
  run.AddAll();
  EXPECT_EQ(run.mapper.Add(run.drive.events[3]).outcome, MapperOutcome::kRefused);
  EXPECT_EQ(run.table.all().size(), 1u);
}

TEST(DriveMapper, CountsGapsAndGoesOn) {
  DriveRun run({});
  run.drive.events.erase(run.drive.events.begin() + 12);
  run.AddAll();
  EXPECT_EQ(run.mapper.counters().missing_events, 1u);
  run.ExpectTrajectory(0, 15, 1e-4);
}

}  // namespace
}  // namespace rovio_sfm
