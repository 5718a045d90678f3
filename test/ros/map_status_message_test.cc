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
  const MapStatus status = ToMessage(picture, {1, 2, 4});
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
}

TEST(MapStatusMessage, HoldsTheNewestReportsAndCountsAll) {
  MapPicture picture;
  picture.snapshot = SmallMaps(1);
  picture.merges.resize(60);
  for (uint32_t i = 0; i < 60; ++i) {
    picture.merges[i].id = i + 1;
    picture.merges[i].verdict = i < 5 ? MergeVerdict::kAccepted : MergeVerdict::kRefused;
  }
  const MapStatus status = ToMessage(picture, {});
  EXPECT_EQ(status.num_merges_accepted, 5u);
  EXPECT_EQ(status.num_merges_refused, 55u);
  EXPECT_EQ(status.num_merges_provisional, 0u);
  ASSERT_EQ(status.merges.size(), 50u);
  EXPECT_EQ(status.merges.front().id, 11u);
  EXPECT_EQ(status.merges.back().id, 60u);
}

}  // namespace
}  // namespace rovio_sfm
