// Maps that go on from a store as if nothing had happened.
#include <gtest/gtest.h>

#include <filesystem>

#include "merging/two_drives.h"
#include "rovio_sfm/app/mapper.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kBefore = 12;  // frames of each drive before the process ends
constexpr uint32_t kAfter = 20;   // of the second drive since

SyntheticDriveOptions WorldOptions() {
  SyntheticDriveOptions options = TwoDrivesOptions(0.5);
  options.world.num_cams = 2 * (kBefore + kAfter);
  options.world.step = 0.1;
  return options;
}

// A mapper whose frames and maps are kept in a file.
struct Mapping {
  explicit Mapping(const std::filesystem::path& file, const MapOptions& options = {})
      : store(file, StoreAccess::kCreate), mapper(options, &store, &executor) {
    mapper.Restore(&store);
  }

  void Drive(const std::vector<FrameEvent>& events, uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) mapper.Add(events[i]);
    ASSERT_TRUE(mapper.SaveTo(&store)) << store.error();
  }
  std::string Bytes() const { return BytesOf(*mapper.Snapshot()); }

  MapStore store;
  Executor executor{0};
  Mapper mapper;
};

class MapperStore : public ::testing::Test {
 protected:
  const TwoDrives two_ = MakeTwoDrives(WorldOptions());
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "map.db";
};

TEST_F(MapperStore, GivesBackTheBytesOfTwoMergedDrives) {
  std::string saved;
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, kBefore);
    mapping.Drive(two_.b, 0, kBefore);
    mapping.mapper.Add(TrueOverlap(two_, 8, 8));
    mapping.Drive(two_.b, kBefore, kBefore + kAfter);
    saved = mapping.Bytes();
  }
  const Mapping loaded(file_);
  EXPECT_EQ(loaded.Bytes(), saved);
  EXPECT_EQ(loaded.mapper.MergeReports().size(), 1u);
}

TEST_F(MapperStore, WhatWasNotCommittedIsNotThere) {
  std::string saved;
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, kBefore);
    saved = mapping.Bytes();
    mapping.mapper.Add(two_.a[kBefore]);
  }
  const Mapping loaded(file_);
  EXPECT_EQ(loaded.Bytes(), saved);
  EXPECT_EQ(loaded.mapper.NextIndices().at(two_.a[0].id.drive), kBefore);
}

TEST_F(MapperStore, ADriveGoesOnAfterItsLastFrame) {
  for (uint32_t begin = 0; begin < kBefore + kAfter; begin += 4) {
    Mapping mapping(file_);
    mapping.Drive(two_.a, begin, begin + 4);
  }
  Mapping loaded(file_);
  loaded.mapper.Finish();
  const auto snapshot = loaded.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 1u);
  SyntheticWorld seen = two_.world;
  seen.cams_from_map.clear();
  for (uint32_t i = 0; i < two_.a.size(); ++i) {
    seen.cams_from_map.push_back(two_.world.cams_from_map[CameraOf(false, i)]);
  }
  const auto error = MeasureTrajectory(snapshot->sessions[0], seen);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->num_frames, kBefore + kAfter);
  EXPECT_LT(error->max_distance, 0.05);
}

TEST_F(MapperStore, AMergeIsUndoneToTheByteAfterALoad) {
  std::string undone;
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, kBefore);
    mapping.Drive(two_.b, 0, kBefore);
    mapping.mapper.Add(TrueOverlap(two_, 8, 8));
    mapping.Drive(two_.b, kBefore, kBefore + 4);
    const std::string merged = mapping.Bytes();
    ASSERT_EQ(mapping.mapper.Unmerge(SessionId{2}).size(), 1u);
    undone = mapping.Bytes();
    ASSERT_NE(undone, merged);
  }
  Mapping loaded(file_);
  ASSERT_EQ(loaded.mapper.Unmerge(SessionId{2}).size(), 1u);
  EXPECT_EQ(loaded.Bytes(), undone);
  ASSERT_TRUE(loaded.mapper.SaveTo(&loaded.store));
  const Mapping again(file_);
  EXPECT_EQ(again.Bytes(), loaded.Bytes());
}

TEST_F(MapperStore, AnOldMapIsMergedWithADriveThatCameLater) {
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, kBefore);
    mapping.mapper.Finish();
    mapping.Drive(two_.a, 0, 0);
  }
  Mapping loaded(file_);
  loaded.Drive(two_.b, 0, kBefore);
  loaded.mapper.Add(TrueOverlap(two_, 8, 8));
  loaded.Drive(two_.b, kBefore, kBefore + kAfter);
  loaded.mapper.Finish();
  const auto snapshot = loaded.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 2u);
  EXPECT_EQ(snapshot->sessions[0].map, snapshot->sessions[1].map);
}

TEST_F(MapperStore, FramesThatWaitForASessionWaitOn) {
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, 1);
    EXPECT_TRUE(mapping.mapper.Snapshot()->sessions[0].frames.empty());
  }
  Mapping loaded(file_);
  loaded.Drive(two_.a, 1, kBefore);
  const auto snapshot = loaded.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 1u);
  ASSERT_FALSE(snapshot->sessions[0].frames.empty());
  EXPECT_EQ(snapshot->sessions[0].frames.front()->front().index, 0u);
}

TEST_F(MapperStore, MappingGoesOnInMemoryWhereTheFileCannotBeWritten) {
  {
    Mapping mapping(file_);
    mapping.Drive(two_.a, 0, kBefore);
  }
  MapStore store(file_, StoreAccess::kRead);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  for (uint32_t i = kBefore; i < kBefore + kAfter; ++i) mapper.Add(two_.a[i]);
  EXPECT_NE(store.error().find("map.db"), std::string::npos) << store.error();
  EXPECT_FALSE(mapper.SaveTo(&store));
  EXPECT_EQ(mapper.counters().keyframes, kBefore + kAfter);
  EXPECT_NE(store.Get(two_.a[kBefore + 1].id), nullptr);
}

}  // namespace
}  // namespace rovio_sfm
