#include "rovio_sfm/io/map_store_journal.h"

#include <gtest/gtest.h>

#include "io/random_records.h"
#include "scene/random_session.h"

namespace rovio_sfm {
namespace {

const FrameMaker kMake{[](const FrameEvent& event) { return BareKeyframe(event.id.index); },
                       [](const FrameEvent& event) { return BareLightFrame(event.id.index); }};

FrameEvent EventAt(uint32_t index) {
  FrameEvent event;
  event.id.index = index;
  return event;
}

// A session with something in every list of its last epoch.
Session JournalledSession() {
  Rng rng(4);
  Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
  for (int step = 0; step < 300; ++step) MutateAtRandom(&session, rng);
  session.Mark();
  for (int step = 0; step < 100; ++step) MutateAtRandom(&session, rng);
  return session;
}

TEST(MapStoreJournal, GivesBackEveryListOfAnEpoch) {
  const Session session = JournalledSession();
  const SessionEpoch& epoch = session.epochs().back();
  for (const size_t size : SizesOf(epoch)) EXPECT_GT(size, 0u);
  const std::string bytes = EpochBytes(epoch, {});
  SessionEpoch again;
  ReadEpoch(BlobOf(bytes), kMake, EventAt, &again);
  EXPECT_EQ(SizesOf(again), SizesOf(epoch));
  EXPECT_EQ(EpochBytes(again, {}), bytes);
  EXPECT_EQ(again.keyframes[0].second->points, epoch.keyframes[0].second->points);
}

TEST(MapStoreJournal, PutsPartsTogetherAgain) {
  const Session session = JournalledSession();
  const SessionEpoch& epoch = session.epochs().back();
  SessionEpoch half = epoch;
  half.poses.resize(half.poses.size() / 2);
  half.members.resize(half.members.size() / 2);
  half.landmarks.clear();
  SessionEpoch again;
  ReadEpoch(BlobOf(EpochBytes(half, {})), kMake, EventAt, &again);
  ReadEpoch(BlobOf(EpochBytes(epoch, SizesOf(half))), kMake, EventAt, &again);
  EXPECT_EQ(EpochBytes(again, {}), EpochBytes(epoch, {}));
}

TEST(MapStoreJournal, RefusesSpoiltBytesWithTheColumnNamed) {
  const Session session = JournalledSession();
  SessionEpoch epoch = session.epochs().back();
  epoch.poses.resize(1);
  epoch.light_poses.resize(1);
  epoch.members.resize(1);
  epoch.positions = {};
  epoch.positions.Add(7, {1.0, 2.0, 3.0});
  epoch.landmarks.resize(1);
  epoch.keyframes.resize(1);
  epoch.light_frames.resize(1);
  epoch.aliases.resize(1);
  EXPECT_GT(CountRefused(EpochBytes(epoch, {}), "journal",
                         [](const Blob& bytes) {
                           SessionEpoch again;
                           ReadEpoch(bytes, kMake, EventAt, &again);
                           return EpochBytes(again, {});
                         }),
            500u);
}

}  // namespace
}  // namespace rovio_sfm
