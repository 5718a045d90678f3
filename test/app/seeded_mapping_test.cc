// Algorithms 1 and 2 of the thesis (§4.3) on the mapper: a second drive from the map of the first.
#include <gtest/gtest.h>

#include "merging/two_drives.h"
#include "rovio_sfm/app/mapper.h"

namespace rovio_sfm {
namespace {

struct Seeding {
  Seeding() {
    for (const FrameEvent& event : two.a) mapper.Add(event);
    mapper.FinishSession(two.a[0].id.drive);
  }

  TwoDrives two = MakeTwoDrives();
  MemoryFrameStore store;
  Executor executor{0};
  Mapper mapper{{}, &store, &executor};
};

TEST(SeededMapping, MapsAWholeDriveInTheMapOfAnother) {
  Seeding setup;
  setup.mapper.AddSeeded(setup.two.b, {TrueOverlap(setup.two, 8, 8)});
  const auto snapshot = setup.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 2u);
  EXPECT_EQ(snapshot->sessions[1].map, snapshot->sessions[0].map);
  EXPECT_NEAR(snapshot->sessions[1].map_from_session.scale, 1.0, 1e-3);  // the other's gauge
  size_t num_frames = 0;
  for (const auto& block : snapshot->sessions[1].frames) num_frames += block->size();
  EXPECT_EQ(num_frames, setup.two.b.size());
}

TEST(SeededMapping, StartsFromItsOwnPairWhereNothingIsSeen) {
  Seeding setup;
  setup.mapper.AddSeeded(setup.two.b, {});
  const auto snapshot = setup.mapper.Snapshot();
  ASSERT_EQ(snapshot->sessions.size(), 2u);
  EXPECT_FALSE(snapshot->sessions[1].map == snapshot->sessions[0].map);
  EXPECT_FALSE(snapshot->sessions[1].frames.empty());
}

}  // namespace
}  // namespace rovio_sfm
