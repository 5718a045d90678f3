#include "rovio_sfm/scene/track_positions.h"

#include <gtest/gtest.h>

#include <vector>

namespace rovio_sfm {
namespace {

TEST(TrackPositions, GivesBackEachInItsOrderHoweverFarApart) {
  const TrackId far = TrackId{1} << 40;
  const std::vector<TrackId> tracks = {3, 4, 900, 900, 7, far, far + 1, 0, far + 256, far + 512, 1};
  TrackPositions positions;
  for (size_t i = 0; i < tracks.size(); ++i) {
    positions.Add(tracks[i], {static_cast<double>(i), 0.25, -1e-9});
  }
  const auto list = positions.List();
  ASSERT_EQ(list.size(), tracks.size());
  for (size_t i = 0; i < tracks.size(); ++i) {
    EXPECT_EQ(list[i].first, tracks[i]);
    EXPECT_EQ(list[i].second, Eigen::Vector3d(static_cast<double>(i), 0.25, -1e-9));
  }
  EXPECT_EQ(positions.size(), tracks.size());
}

TEST(TrackPositions, TakeTwentyFiveBytesEachByRisingTrack) {
  TrackPositions positions;
  for (TrackId track = 1; track <= 1000; ++track) positions.Add(2 * track, {1.0, 2.0, 3.0});
  positions.Shrink();
  EXPECT_EQ(positions.NumBytes(), 25000u);
}

}  // namespace
}  // namespace rovio_sfm
