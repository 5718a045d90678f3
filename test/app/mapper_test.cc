#include "rovio_sfm/app/mapper.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "synthetic/synthetic_drive.h"

namespace rovio_sfm {
namespace {

// A noisy drive with light frames, links and odometry.
SyntheticDrive FullDrive(uint64_t seed = 1) {
  SyntheticDriveOptions options;
  options.world.seed = seed;
  options.world.num_cams = 21;
  options.world.step = 0.2;
  options.world.noise_px = 0.7;
  options.light_frames = 1;
  options.track_length = 9;
  options.with_links = true;
  options.metres_per_unit = 0.5;
  return MakeSyntheticDrive(options);
}

struct Mapping {
  explicit Mapping(int num_threads = 0, const MapOptions& options = {})
      : executor(num_threads), mapper(options, &store, &executor) {}
  void Add(const SyntheticDrive& drive) {
    for (const FrameEvent& event : drive.events) mapper.Add(event);
  }
  MemoryFrameStore store;
  Executor executor;
  Mapper mapper;
};

std::string MapOnce(int num_threads) {
  Mapping setup(num_threads);
  setup.Add(FullDrive());
  setup.mapper.Finish();
  return BytesOf(*setup.mapper.Snapshot());
}

TEST(Mapper, RecoversTheTrajectoryUpToASimilarity) {
  const SyntheticDrive drive = FullDrive();
  Mapping setup;
  setup.Add(drive);
  setup.mapper.Finish();
  const auto snapshot = setup.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 1u);
  const SessionSnapshot& session = snapshot->sessions[0];
  EXPECT_EQ(session.state, SessionState::kFinished);
  EXPECT_TRUE(session.scale.has_value());
  const auto error = MeasureTrajectory(session, drive.world);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->num_frames, 21u);
  EXPECT_LT(error->max_distance, 0.05);
  EXPECT_LT(error->max_rotation_rad, 0.02);
}

TEST(Mapper, GivesTheSameBytesTwiceAndWithThreads) {
  const std::string first = MapOnce(0);
  EXPECT_GT(first.size(), 1000u);
  EXPECT_EQ(MapOnce(0), first);
  EXPECT_EQ(MapOnce(2), first);
}

TEST(Mapper, RefusesEventsThatDoNotFitAndLeavesTheMapsAsTheyWere) {
  const SyntheticDrive drive = FullDrive();
  Mapping setup;
  for (size_t i = 0; i < 13; ++i) setup.mapper.Add(drive.events[i]);
  const std::string before = BytesOf(*setup.mapper.Snapshot());
  const MapperReport again = setup.mapper.Add(drive.events[12]);
  EXPECT_EQ(again.outcome, MapperOutcome::kRefused);
  EXPECT_EQ(again.reason, "index 12: expected 13 or more");
  FrameEvent other_camera = drive.events[13];
  other_camera.camera.fx += 1.0;
  EXPECT_EQ(setup.mapper.Add(other_camera).outcome, MapperOutcome::kRefused);
  EXPECT_EQ(BytesOf(*setup.mapper.Snapshot()), before);
  EXPECT_EQ(setup.mapper.counters().refused_events, 2u);
  EXPECT_NE(setup.mapper.Add(drive.events[13]).outcome, MapperOutcome::kRefused);
}

TEST(Mapper, PosesALostFrameAtTheEnd) {
  SyntheticDriveOptions options;
  options.blind = {7};
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  const FrameEvent& lost = drive.events[7];
  Mapping setup;
  setup.Add(drive);
  setup.mapper.FinishDrives();
  ASSERT_EQ(setup.mapper.maps().sessions().FindHolder(lost.id), nullptr);
  EXPECT_FALSE(setup.mapper.Rejoin(lost, {}));
  EXPECT_TRUE(setup.mapper.Rejoin(lost, TruePlace(drive, 7, 4)));
  setup.mapper.Finish();
  const auto error = MeasureTrajectory(setup.mapper.Snapshot()->sessions.at(0), drive.world);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->num_frames, drive.events.size());
  EXPECT_LT(error->max_distance, 1e-3);
}

TEST(Mapper, MapsDrivesApart) {
  const SyntheticDrive a = FullDrive(1), b = FullDrive(2);
  Mapping together, alone;
  for (size_t i = 0; i < a.events.size(); ++i) {
    together.mapper.Add(a.events[i]);
    together.mapper.Add(b.events[i]);
  }
  together.mapper.Finish();
  alone.Add(b);
  alone.mapper.Finish();
  const auto both = together.mapper.Snapshot();
  ASSERT_EQ(both->sessions.size(), 2u);
  EXPECT_LT(both->sessions[0].id.value, both->sessions[1].id.value);
  EXPECT_LT(MeasureTrajectory(both->sessions[0], a.world)->max_distance, 0.05);
  MapSnapshot second;
  second.sessions = {both->sessions[1]};
  second.sessions[0].id = {1};
  EXPECT_EQ(BytesOf(second), BytesOf(*alone.mapper.Snapshot()));
}

TEST(Mapper, FinishesOnlyDrivesItKnows) {
  Mapping setup;
  const SyntheticDrive drive = FullDrive();
  EXPECT_FALSE(setup.mapper.FinishSession(drive.events[0].id.drive));
  setup.mapper.Add(drive.events[0]);
  EXPECT_TRUE(setup.mapper.FinishSession(drive.events[0].id.drive));
  EXPECT_EQ(setup.mapper.Snapshot()->sessions[0].state, SessionState::kFinished);
}

TEST(Mapper, SnapshotsStayAndShareWhatDidNotChange) {
  Mapping setup;
  EXPECT_TRUE(setup.mapper.Snapshot()->sessions.empty());
  setup.Add(FullDrive());
  const auto first = setup.mapper.Snapshot(), second = setup.mapper.Snapshot();
  EXPECT_LT(first->version, second->version);
  ASSERT_FALSE(first->sessions[0].landmarks.empty());
  EXPECT_EQ(first->sessions[0].landmarks, second->sessions[0].landmarks);
  EXPECT_EQ(first->sessions[0].frames, second->sessions[0].frames);
  const std::string before = BytesOf(*first);
  setup.mapper.Finish();
  EXPECT_EQ(BytesOf(*first), before);
  EXPECT_NE(BytesOf(*setup.mapper.Snapshot()), before);
}

TEST(Mapper, MeasuresItsStages) {
  MemoryFrameStore store;
  Executor executor(0);
  int64_t now_ns = 0;
  StageTimes times([&now_ns] { return now_ns += 10; });
  Mapper mapper({}, &store, &executor, &times);
  for (const FrameEvent& event : FullDrive().events) mapper.Add(event);
  mapper.Finish();
  for (const char* stage : {"bootstrap", "resect", "search", "triangulate", "adjust_locally",
                            "adjust_finally", "light"}) {
    EXPECT_EQ(times.totals().count(stage), 1u) << stage;
  }
}

TEST(MapperDeathTest, EndsOnInvalidOptions) {
  MapOptions options;
  options.max_weak_frames = -5;
  testing::GTEST_FLAG(death_test_style) = "threadsafe";  // a library has started threads already
  EXPECT_DEATH(Mapping(0, options), "max_weak_frames");
}

}  // namespace
}  // namespace rovio_sfm
