#include "rovio_sfm/app/mapping_engine.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// A light frame: it needs no features to be taken in.
FrameEvent Event(const std::string& robot, uint32_t nonce, uint32_t index) {
  FrameEvent event;
  event.id = {{robot, 1000, nonce}, index};
  event.kind = FrameKind::kLight;
  event.stamp_ns = 1000 + 1000 * static_cast<int64_t>(index);
  event.camera = {500.0, 500.0, 320.0, 240.0, 0, 0, 0, 0, 0, 640, 480};
  event.features = std::make_shared<FrameFeatures>();
  return event;
}

TEST(MappingEngine, CountsWhatComesInAndShowsASession) {
  MappingEngine engine((MapOptions()));
  EXPECT_EQ(engine.Picture().num_events, 0u);
  EXPECT_NE(engine.Add(Event("rovio1", 1, 0)).outcome, MapperOutcome::kRefused);
  EXPECT_EQ(engine.Picture().num_events, 1u);
}

TEST(MappingEngine, KnowsWhichIndexIsMissing) {
  MappingEngine engine((MapOptions()));
  EXPECT_EQ(engine.NextIndex(Event("rovio1", 1, 7).id), 0u);
  engine.Add(Event("rovio1", 1, 0));
  EXPECT_EQ(engine.NextIndex(Event("rovio1", 1, 4).id), 1u);
  EXPECT_EQ(engine.NextIndex(Event("rovio1", 1, 0).id), 0u);
}

TEST(MappingEngine, RefusesAnEndedDrive) {
  MappingEngine engine((MapOptions()));
  engine.Add(Event("rovio1", 1, 0));
  EXPECT_NE(engine.Add(Event("rovio1", 2, 0)).outcome, MapperOutcome::kRefused);
  const MapperReport report = engine.Add(Event("rovio1", 1, 1));
  EXPECT_EQ(report.outcome, MapperOutcome::kRefused);
  EXPECT_NE(report.reason.find("two frontends"), std::string::npos);
}

TEST(MappingEngine, TwoRobotsDriveSideBySide) {
  MappingEngine engine((MapOptions()));
  for (uint32_t i = 0; i < 3; ++i) {
    EXPECT_NE(engine.Add(Event("rovio1", 1, i)).outcome, MapperOutcome::kRefused);
    EXPECT_NE(engine.Add(Event("rovio2", 1, i)).outcome, MapperOutcome::kRefused);
  }
}

TEST(MappingEngine, AnchorsRobotsAtTheirNewestFramesAndThoseWithOdometry) {
  MappingEngine engine((MapOptions()));
  TwoDrives two = MakeTwoDrives();
  const auto last = static_cast<uint32_t>(two.a.size()) - 1;
  for (FrameEvent& event : two.a) {
    event.odometry = event.id.index < last ? std::optional(OdometrySample{}) : std::nullopt;
    EXPECT_NE(engine.Add(event).outcome, MapperOutcome::kRefused);
  }
  const std::string& robot = two.a.front().id.drive.robot;
  EXPECT_EQ(engine.Picture().anchors.at(robot).index, last);
  EXPECT_EQ(engine.Picture().wheel_anchors.at(robot).index, last - 1);
  EXPECT_EQ(engine.Picture().wheel_anchors.at(robot).drive, two.a.front().id.drive);
}

TEST(MappingEngine, FinishingAnUnknownRobotSaysSo) {
  MappingEngine engine((MapOptions()));
  EXPECT_FALSE(engine.FinishSession("rovio9"));
}

TEST(MappingEngine, FinishingNamesTheSessionThatWasClosed) {
  MappingEngine engine((MapOptions()));
  const SyntheticDrive drive = MakeSyntheticDrive({});
  for (const FrameEvent& event : drive.events) engine.Add(event);
  const auto closed = engine.FinishSession(drive.events[0].id.drive.robot);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->id.value, 1u);
  EXPECT_TRUE(closed->has_frames);
  EXPECT_FALSE(engine.FinishSession(drive.events[0].id.drive.robot));
}

TEST(MappingEngine, FinishingALostRobotDoesNotNameTheSessionBefore) {
  SyntheticDriveOptions options;
  options.blind = {9, 10, 11, 12};
  MappingEngine engine((MapOptions()));
  const SyntheticDrive drive = MakeSyntheticDrive(options);
  for (size_t i = 0; i < 13; ++i) engine.Add(drive.events[i]);
  const auto sessions = engine.Picture().snapshot->sessions;
  ASSERT_EQ(sessions.size(), 2u);
  ASSERT_EQ(sessions[0].state, SessionState::kLost);
  ASSERT_EQ(sessions[1].state, SessionState::kBootstrapping);
  const auto closed = engine.FinishSession(drive.events[0].id.drive.robot);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->id.value, 2u);
  EXPECT_FALSE(closed->has_frames);
  EXPECT_EQ(engine.Picture().snapshot->sessions[0].state, SessionState::kLost);
}

TEST(MappingEngine, SharesTheReportsAsLongAsTheyAreTheSame) {
  const TwoDrives two = MakeTwoDrives();
  MappingEngine engine((MapOptions()));
  engine.Add(two.a[0]);
  const MapPicture first = engine.Picture();
  engine.Add(TrueOverlap(two, 8, 8));
  EXPECT_EQ(engine.Picture().merges, first.merges);
  EXPECT_GT(engine.Picture().number, first.number);
  for (const FrameEvent& event : two.a) engine.Add(event);
  for (const FrameEvent& event : two.b) engine.Add(event);
  EXPECT_NE(engine.Picture().merges, first.merges);
  EXPECT_TRUE(first.merges->empty());
}

TEST(MappingEngine, ShowsTheMergeThatAPlaceMatchBrings) {
  const TwoDrives two = MakeTwoDrives();
  MappingEngine engine((MapOptions()));
  engine.Add(TrueOverlap(two, 8, 8));  // waits: its drives are not known yet
  EXPECT_EQ(engine.Picture().num_place_matches, 1u);
  EXPECT_TRUE(engine.Picture().merges->empty());
  for (const FrameEvent& event : two.a) engine.Add(event);
  for (const FrameEvent& event : two.b) engine.Add(event);
  const MapPicture picture = engine.Picture();
  ASSERT_EQ(picture.merges->size(), 1u);
  EXPECT_EQ((*picture.merges)[0].verdict, MergeVerdict::kAccepted) << (*picture.merges)[0].reason;
  EXPECT_EQ(picture.snapshot->sessions[1].map.value, 1u);
}

TEST(MappingEngine, DriveGoesOnAfterReset) {
  MappingEngine engine((MapOptions()));
  engine.Add(Event("rovio1", 1, 0));
  const uint64_t epoch = engine.Picture().epoch;
  engine.Reset();
  EXPECT_NE(engine.Picture().epoch, epoch);
  EXPECT_NE(engine.Add(Event("rovio1", 1, 1)).outcome, MapperOutcome::kRefused);
}

std::unique_ptr<StoreFolder> StoreIn(const TemporaryFolder& folder) {
  return std::make_unique<StoreFolder>(folder.Path(), ExistingStore::kResume);
}

TEST(MappingEngine, GoesOnWithWhatWasSaved) {
  TemporaryFolder folder;
  const TwoDrives two = MakeTwoDrives();
  const DriveId drive = two.a[0].id.drive;
  {
    MappingEngine engine({}, StoreIn(folder));
    engine.Add(Event(drive.robot, 99, 0));
    for (uint32_t i = 0; i < 8; ++i) engine.Add(two.a[i]);
    EXPECT_TRUE(engine.Picture().saved_up_to.empty());
    engine.Save();
    ASSERT_EQ(engine.Picture().saved_up_to.size(), 2u);
    engine.Add(two.a[8]);  // not saved
  }
  MappingEngine engine({}, StoreIn(folder));
  EXPECT_EQ(engine.NextIndex({drive, 12}), 8u);
  EXPECT_EQ(engine.Add(Event(drive.robot, 99, 1)).outcome, MapperOutcome::kRefused) << "it ended";
  for (uint32_t i = 8; i < two.a.size(); ++i) engine.Add(two.a[i]);
  engine.Finish();
  const MapPicture picture = engine.Picture();
  EXPECT_EQ(picture.store_error, "");
  ASSERT_EQ(picture.saved_up_to.size(), 2u);
  EXPECT_EQ(picture.counters.keyframes, two.a.size());
}

TEST(MappingEngine, ADriveGoesOnAfterAMapOfItsRobotWasLoaded) {
  TemporaryFolder folder, other;
  const TwoDrives two = MakeTwoDrives();
  const std::string robot = two.a[0].id.drive.robot;
  {
    MappingEngine yesterday({}, StoreIn(other));
    for (uint32_t i = 0; i < 8; ++i) yesterday.Add(two.a[i]);
    yesterday.Save();
  }
  MappingEngine engine({}, StoreIn(folder));
  engine.Add(Event(robot, 99, 0));
  engine.Load(StoreFolder::FileIn(other.Path()));
  const MapperReport report = engine.Add(Event(robot, 99, 1));
  EXPECT_NE(report.outcome, MapperOutcome::kRefused) << report.reason;
  EXPECT_EQ(engine.Add(two.a[8]).outcome, MapperOutcome::kRefused) << "that drive is yesterday's";
}

TEST(MappingEngine, ResetPutsTheStoreAside) {
  TemporaryFolder folder;
  const TwoDrives two = MakeTwoDrives();
  MappingEngine engine({}, StoreIn(folder));
  for (uint32_t i = 0; i < 8; ++i) engine.Add(two.a[i]);
  const std::filesystem::path aside = engine.Reset();
  MapStore old(aside, StoreAccess::kRead);
  EXPECT_EQ(old.frames().ReadIndices(two.a[0].id.drive).size(), 8u);
  EXPECT_TRUE(engine.Picture().saved_up_to.empty());
}

}  // namespace
}  // namespace rovio_sfm
