#include "rovio_sfm/merging/merge_ledger.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

MergeRecord Merge(uint32_t a, uint32_t b, double scale) {
  MergeRecord record;
  record.report.verdict = MergeVerdict::kAccepted;
  record.report.other_session = {a};
  record.report.query_session = {b};
  record.report.query_from_other.scale = scale;
  record.links = {{{{a}, 1, 2}, {{b}, 3, 4}}, {{{a}, 1, 5}, {{b}, 3, 6}}};
  return record;
}

TEST(MergeLedger, PlacesSessionsAlongAcceptedMerges) {
  MergeLedger ledger;
  ledger.Keep(Merge(2, 3, 2.0));
  ledger.Keep(Merge(1, 2, 0.5));
  ledger.Place();
  EXPECT_EQ(ledger.PlaceOf({3}).map.value, 1u);
  EXPECT_NEAR(ledger.PlaceOf({2}).map_from_session.scale, 2.0, 1e-12);
  EXPECT_NEAR(ledger.PlaceOf({3}).map_from_session.scale, 1.0, 1e-12);
  EXPECT_EQ(ledger.PlaceOf({4}).map.value, 4u);
}

TEST(MergeLedger, ForgetsMergesThatAreUndone) {
  MergeLedger ledger;
  ledger.Keep(Merge(1, 2, 1.0)).report.verdict = MergeVerdict::kUndone;
  ledger.Place();
  EXPECT_EQ(ledger.PlaceOf({2}).map.value, 2u);
  EXPECT_TRUE(ledger.LinksOf({1}).empty());
}

TEST(MergeLedger, KeepsOnlyTheLinksItIsTold) {
  MergeLedger ledger;
  const MergeRecord& record = ledger.Keep(Merge(1, 2, 1.0));
  ledger.Place();
  ASSERT_EQ(ledger.LinksOf({1}).size(), 2u);
  EXPECT_TRUE(ledger.LinksOf({1}, &record).empty());
  ledger.KeepLinks({1}, {record.links[1]});
  ASSERT_EQ(ledger.LinksOf({1}).size(), 1u);
  EXPECT_EQ(ledger.LinksOf({1})[0].b.feature, 6u);
}

TEST(MergeLedger, NumbersRecordsAndRaisesRevisions) {
  MergeLedger ledger;
  EXPECT_EQ(ledger.Keep(Merge(1, 2, 1.0)).report.id, 1u);
  EXPECT_EQ(ledger.Keep(Merge(2, 3, 1.0)).report.id, 2u);
  ledger.Place();
  EXPECT_EQ(ledger.PlaceOf({2}).revision, 0u);
  ledger.RaiseRevision({1});
  EXPECT_EQ(ledger.PlaceOf({2}).revision, 1u);
}

TEST(MergeLedger, KnowsWhichFramesItJudgedTogether) {
  const FrameId a{{"first", 1, 1}, 4}, b{{"second", 2, 1}, 7}, c{{"first", 1, 1}, 5};
  MergeLedger ledger;
  MergeRecord record = Merge(1, 2, 1.0);
  record.match.query = b;
  record.match.pairs.resize(1);
  record.match.pairs[0].other = a;
  ledger.Keep(std::move(record));
  EXPECT_TRUE(ledger.HasJudged(a, b));
  EXPECT_TRUE(ledger.HasJudged(b, a));
  EXPECT_FALSE(ledger.HasJudged(b, c));
}

TEST(MergeLedger, CountsOverlapsOfTwoDrivesBothWays) {
  MergeLedger ledger;
  MergeRecord record = Merge(1, 2, 1.0);
  record.report.query.drive.robot = "a";
  record.report.other.drive.robot = "b";
  ledger.Keep(record);
  EXPECT_EQ(ledger.CountAccepted(record.report.other.drive, record.report.query.drive), 1);
  EXPECT_EQ(ledger.CountAccepted(record.report.query.drive, record.report.query.drive), 0);
}

TEST(MergeLedger, LendsTheSessionsOfAMapRootFirst) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  SessionTable table;
  table.Add(&b);
  table.Add(&a);
  MergeLedger ledger;
  ledger.Keep(Merge(2, 1, 1.0));
  ledger.Place();
  const std::vector<PlacedSession> placed = ledger.SessionsOf({1}, table);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].session, &a);
  EXPECT_TRUE(ledger.SessionsOf({2}, table).empty());
}

}  // namespace
}  // namespace rovio_sfm
