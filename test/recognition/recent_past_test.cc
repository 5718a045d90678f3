#include "rovio_sfm/recognition/recent_past.h"

#include <gtest/gtest.h>

#include <numeric>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

RecentPastOptions Options(int min_keyframes, int min_shared_tracks) {
  RecentPastOptions options;
  options.min_keyframes = min_keyframes;
  options.min_shared_tracks = min_shared_tracks;
  return options;
}

std::vector<TrackId> Tracks(TrackId first, size_t count) {
  std::vector<TrackId> tracks(count);
  std::iota(tracks.begin(), tracks.end(), first);
  return tracks;
}

TEST(RecentPast, FirstKeyframeHasNothingBefore) {
  RecentPast past(Options(3, 5));
  EXPECT_EQ(past.Add(Tracks(1, 10), {}), 0u);
}

TEST(RecentPast, CountsKeyframesWhileTracksGoOnBriefly) {
  RecentPast past(Options(3, 5));
  for (size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(past.Add(Tracks(1 + 5 * i, 10), {}), i < 3 ? 0 : i - 3);
  }
}

TEST(RecentPast, GoesBackToWhereSharedTracksBegan) {
  RecentPast past(Options(1, 5));
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ(past.Add(Tracks(1, 10), {}), 0u);
}

TEST(RecentPast, AFewOldTracksDoNotStretchIt) {
  RecentPast past(Options(2, 5));
  std::vector<size_t> allowed;
  for (size_t i = 0; i < 10; ++i) {
    std::vector<TrackId> tracks = Tracks(100 + 5 * i, 10);
    tracks.push_back(1);  // seen all the time
    allowed.push_back(past.Add(tracks, {}));
  }
  EXPECT_EQ(allowed.back(), 7u);
}

TEST(RecentPast, ABreakEndsIt) {
  RecentPast past(Options(20, 5));
  for (size_t i = 0; i < 4; ++i) past.Add(Tracks(1, 10), {});
  EXPECT_EQ(past.Add(Tracks(1000, 10), {}), 4u);
  EXPECT_EQ(past.Add(Tracks(1000, 10), {}), 4u);  // what lies before the break stays allowed
}

TEST(RecentPast, EndsWhereTheDriveWasLost) {
  RecentPast past(Options(20, 5));
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(past.Add(Tracks(1, 10), {}), 0u);
  past.Break(2);
  EXPECT_EQ(past.Add(Tracks(1, 10), {}), 4u);  // though tracks go on
  past.Break(100);
  EXPECT_EQ(past.Add(Tracks(1, 10), {}), 0u);
}

TEST(RecentPast, LinkedTracksBeganWithTheOlder) {
  RecentPast past(Options(1, 5));
  past.Add(Tracks(1, 5), {});
  past.Add(Tracks(1, 10), {});
  std::vector<TrackLink> links;
  for (TrackId i = 1; i <= 5; ++i) links.push_back({i, i + 5});
  EXPECT_EQ(past.Add(Tracks(6, 5), links), 0u);
}

TEST(RecentPast, LinkedTracksBeganWithTheOlderWhicheverIsNamedFirst) {
  RecentPast past(Options(1, 5));
  past.Add(Tracks(1, 5), {});
  past.Add(Tracks(1, 10), {});
  std::vector<TrackLink> links;
  for (TrackId i = 1; i <= 5; ++i) links.push_back({i + 5, i});
  EXPECT_EQ(past.Add(Tracks(6, 5), links), 0u);
}

TEST(RecentPast, RemembersTracksThatPause) {
  RecentPast past(Options(1, 5));
  const auto with_old = [](std::vector<TrackId> tracks) {
    for (const TrackId track : Tracks(1, 10)) tracks.push_back(track);
    return tracks;
  };
  past.Add(with_old(Tracks(101, 10)), {});
  for (TrackId i = 1; i < 50; ++i) EXPECT_GT(past.Add(Tracks(101 + 5 * i, 10), {}) + 3, i);
  EXPECT_EQ(past.Add(with_old(Tracks(1001, 10)), {}), 0u);
}

TEST(RecentPast, FeaturesWithoutTrackCountForNothing) {
  RecentPast past(Options(20, 5));
  past.Add(std::vector<TrackId>(10, 0), {});
  EXPECT_EQ(past.Add(std::vector<TrackId>(10, 0), {}), 1u);
}

TEST(RecentPastOptions, NamesWhatIsOutOfRange) {
  std::string error;
  EXPECT_TRUE(IsValid(RecentPastOptions(), &error));
  EXPECT_FALSE(IsValid(Options(0, 5), &error));
  EXPECT_NE(error.find("min_keyframes"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
