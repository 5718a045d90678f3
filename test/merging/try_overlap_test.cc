#include "rovio_sfm/merging/try_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

double ScaleError(const MergeReport& report) {
  return std::abs(std::log(report.query_from_other.scale / OtherGauge().scale));
}

TEST(TryOverlap, ProvesATrueOverlap) {
  for (const double noise_px : {0.0, 0.7}) {
    const TwoDrives two = MakeTwoDrives(TwoDrivesOptions(noise_px));
    const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
    const PlaceMatch match = TrueOverlap(two, 8, 8);
    const OverlapTrial trial =
        TryOverlap(a, b, match.query, match.pairs, MapOptions(), StoreOf(two));
    EXPECT_EQ(trial.report.verdict, MergeVerdict::kAccepted) << trial.report.reason;
    EXPECT_LT(ScaleError(trial.report), noise_px == 0.0 ? 1e-6 : 0.01);
    EXPECT_GT(trial.links.size(), match.pairs[0].inliers.size());
    EXPECT_TRUE(std::is_sorted(trial.links.begin(), trial.links.end()));
  }
}

TEST(TryOverlap, LinksNoWeakFrame) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {});
  Session b = MappedSession(two, true, OtherGauge());
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  const auto num_links_of_9 = [&] {
    const auto links = TryOverlap(a, b, match.query, match.pairs, MapOptions(), StoreOf(two)).links;
    return std::count_if(links.begin(), links.end(),
                         [](const FeatureLink& link) { return link.b.frame == 9; });
  };
  EXPECT_GT(num_links_of_9(), 10);
  b.SetWeak(9, true);
  EXPECT_EQ(num_links_of_9(), 0);
}

TEST(TryOverlap, ChangesNothing) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const std::string before = BytesOf(a) + BytesOf(b);
  const PlaceMatch match = TrueOverlap(two, 8, 8);
  TryOverlap(a, b, match.query, match.pairs, MapOptions(), StoreOf(two));
  EXPECT_EQ(BytesOf(a) + BytesOf(b), before);
}

TEST(TryOverlap, RefusesTooFewMatches) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  PlaceMatch match = TrueOverlap(two, 8, 8);
  match.pairs[0].inliers.resize(4);
  const OverlapTrial trial = TryOverlap(a, b, match.query, match.pairs, MapOptions(), StoreOf(two));
  EXPECT_EQ(trial.report.verdict, MergeVerdict::kRefused);
  EXPECT_NE(trial.report.reason.find("no alignment"), std::string::npos);
  EXPECT_TRUE(trial.links.empty());
}

}  // namespace
}  // namespace rovio_sfm
