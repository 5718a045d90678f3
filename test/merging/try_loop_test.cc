#include "rovio_sfm/merging/try_loop.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

TEST(TryLoop, LinksWhatFitsTheMap) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  const auto trial =
      TryLoop({&a, {}}, {&b, Inverse(OtherGauge())}, match.query, match.pairs, MapOptions());
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->report.verdict, MergeVerdict::kAccepted);
  EXPECT_EQ(trial->report.kind, MergeKind::kLoop);
  EXPECT_EQ(trial->links.size(), match.pairs[0].inliers.size());
}

TEST(TryLoop, LeavesWhatGapesToBeJudged) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  EXPECT_FALSE(TryLoop({&a, {}}, {&b, {}}, match.query, match.pairs, MapOptions()));
}

TEST(TryLoop, LeavesTooFewMatchesToBeJudged) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  PlaceMatch match = TrueOverlap(two, 8, 8);
  match.pairs[0].inliers.resize(10);
  EXPECT_FALSE(TryLoop({&a, {}}, {&b, {}}, match.query, match.pairs, MapOptions()));
}

TEST(TryLoop, CountsALinkOnce) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  PlaceMatch match = TrueOverlap(two, 8, 8);
  match.pairs.push_back(match.pairs[0]);
  const auto trial = TryLoop({&a, {}}, {&b, {}}, match.query, match.pairs, MapOptions());
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->links.size(), match.pairs[0].inliers.size());
  EXPECT_EQ(trial->report.num_links, match.pairs[0].inliers.size());
}

TEST(TryLoop, PassesOverFeaturesThatDoNotExist) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  PlaceMatch match = TrueOverlap(two, 8, 8);
  const size_t count = match.pairs[0].inliers.size();
  match.pairs[0].inliers.push_back({100000, 0});
  const auto trial = TryLoop({&a, {}}, {&b, {}}, match.query, match.pairs, MapOptions());
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->links.size(), count);
}

}  // namespace
}  // namespace rovio_sfm
