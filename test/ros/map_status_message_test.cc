#include "rovio_sfm/ros/map_status_message.h"

#include <gtest/gtest.h>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

TEST(MapStatusMessage, CountsWhatCameInAndWhatDidNot) {
  MapPicture picture;
  picture.snapshot = SmallMaps(2);
  picture.num_events = 6;
  picture.num_place_matches = 9;
  picture.num_matches_waiting = 3;
  picture.num_matches_repeated = 5;
  const MapStatus status = MapStatusWriter().Write(picture, {1, 2, 7, 4, 8}).value();
  EXPECT_EQ(status.header.stamp, ros::Time(3));
  EXPECT_EQ(status.sessions.size(), 2u);
  EXPECT_EQ(status.maps.size(), 2u);
  EXPECT_EQ(status.num_events, 6u);
  EXPECT_EQ(status.num_refused, 1u);
  EXPECT_EQ(status.num_dropped, 2u);
  EXPECT_EQ(status.num_place_matches, 9u);
  EXPECT_EQ(status.num_place_matches_waiting, 3u);
  EXPECT_EQ(status.num_place_matches_repeated, 5u);
  EXPECT_EQ(status.num_place_matches_refused, 4u);
  EXPECT_EQ(status.num_place_matches_dropped, 8u);
  EXPECT_EQ(status.num_gaps_lost, 7u);
}

TEST(MapStatusMessage, HoldsTheNewestReportsAndCountsAll) {
  MapPicture picture;
  picture.snapshot = SmallMaps(1);
  std::vector<MergeReport> merges(60);
  for (uint32_t i = 0; i < 60; ++i) {
    merges[i].id = i + 1;
    merges[i].verdict = i < 5 ? MergeVerdict::kAccepted : MergeVerdict::kRefused;
  }
  picture.merges = std::make_shared<const std::vector<MergeReport>>(merges);
  const MapStatus status = MapStatusWriter().Write(picture, {}).value();
  EXPECT_EQ(status.num_merges_accepted, 5u);
  EXPECT_EQ(status.num_merges_refused, 55u);
  EXPECT_EQ(status.num_merges_provisional, 0u);
  ASSERT_EQ(status.merges.size(), 50u);
  EXPECT_EQ(status.merges.front().id, 11u);
  EXPECT_EQ(status.merges.back().id, 60u);
}

TEST(MapStatusMessage, IsWrittenAgainOnlyWhenSomethingIsNew) {
  MapStatusWriter writer;
  MapPicture picture;
  picture.snapshot = SmallMaps(2);
  EXPECT_TRUE(writer.Write(picture, {}));
  EXPECT_FALSE(writer.Write(picture, {}));
  EXPECT_TRUE(writer.Write(picture, {1, 0, 0, 0, 0}));
  EXPECT_FALSE(writer.Write(picture, {1, 0, 0, 0, 0}));
  ++picture.number;
  EXPECT_TRUE(writer.Write(picture, {1, 0, 0, 0, 0}));
}

TEST(MapStatusMessage, CountsAgainWhatChanged) {
  MapStatusWriter writer;
  MapPicture picture;
  picture.snapshot = SmallMaps(2);
  writer.Write(picture, {});
  MapSnapshot changed = *picture.snapshot;
  changed.sessions[1].frames.push_back(changed.sessions[1].frames[0]);
  changed.sessions[1].landmarks.clear();
  ++changed.sessions[1].revision;
  picture.snapshot = std::make_shared<const MapSnapshot>(changed);
  ++picture.number;
  const MapStatus status = writer.Write(picture, {}).value();
  EXPECT_EQ(status.sessions[0].num_keyframes, 3u);
  EXPECT_EQ(status.sessions[1].num_keyframes, 6u);
  EXPECT_EQ(status.maps[0].num_landmarks, 2u);
  EXPECT_EQ(status.maps[1].num_landmarks, 0u);
}

TEST(MapStatusMessage, CountsAgainWhenMapsWereForgotten) {
  MapStatusWriter writer;
  MapPicture picture;
  picture.snapshot = SmallMaps(1);
  writer.Write(picture, {});
  MapSnapshot other = *picture.snapshot;  // the same numbers, another session
  other.sessions[0].frames.clear();
  picture.snapshot = std::make_shared<const MapSnapshot>(other);
  ++picture.number;
  ++picture.epoch;
  const MapStatus status = writer.Write(picture, {}).value();
  EXPECT_EQ(status.sessions[0].num_keyframes, 0u);
  EXPECT_TRUE(status.maps.empty());
}

}  // namespace
}  // namespace rovio_sfm
