#include "rovio_sfm/merging/merge_list.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

MergeEdit Merge(uint32_t a, uint32_t b, double scale) {
  MergeEdit edit;
  edit.report.verdict = MergeVerdict::kAccepted;
  edit.report.other_session = {a};
  edit.report.query_session = {b};
  edit.report.query_from_other.scale = scale;
  edit.links = std::vector<FeatureLink>{{{{a}, 1, 2}, {{b}, 3, 4}}, {{{a}, 1, 5}, {{b}, 3, 6}}};
  return edit;
}

TEST(MergeList, PlacesSessionsAlongAcceptedMerges) {
  MergeList list;
  list.Keep(Merge(2, 3, 2.0));
  list.Keep(Merge(1, 2, 0.5));
  list.Place();
  EXPECT_EQ(list.PlaceOf({3}).map.value, 1u);
  EXPECT_NEAR(list.PlaceOf({2}).map_from_session.scale, 2.0, 1e-12);
  EXPECT_NEAR(list.PlaceOf({3}).map_from_session.scale, 1.0, 1e-12);
  EXPECT_EQ(list.PlaceOf({4}).map.value, 4u);
}

TEST(MergeList, ForgetsMergesThatAreUndone) {
  MergeList list;
  list.Keep(Merge(1, 2, 1.0)).report.verdict = MergeVerdict::kUndone;
  list.Place();
  EXPECT_EQ(list.PlaceOf({2}).map.value, 2u);
  EXPECT_TRUE(list.LinksOf({1}).empty());
}

TEST(MergeList, KeepsOnlyTheLinksItIsTold) {
  MergeList list;
  const MergeEdit& edit = list.Keep(Merge(1, 2, 1.0));
  list.Place();
  ASSERT_EQ(list.LinksOf({1}).size(), 2u);
  EXPECT_TRUE(list.LinksOf({1}, &edit).empty());
  list.KeepLinks({1}, {edit.links.List()[1]});
  ASSERT_EQ(list.LinksOf({1}).size(), 1u);
  EXPECT_EQ(list.LinksOf({1})[0].b.feature, 6u);
}

TEST(MergeList, NumbersEditsAndRaisesRevisions) {
  MergeList list;
  EXPECT_EQ(list.Keep(Merge(1, 2, 1.0)).report.id, 1u);
  EXPECT_EQ(list.Keep(Merge(2, 3, 1.0)).report.id, 2u);
  list.Place();
  EXPECT_EQ(list.PlaceOf({2}).revision, 0u);
  list.RaiseRevision({1});
  EXPECT_EQ(list.PlaceOf({2}).revision, 1u);
}

TEST(MergeList, KnowsWhichFramesItJudgedTogether) {
  const FrameId a{{"first", 1, 1}, 4}, b{{"second", 2, 1}, 7}, c{{"first", 1, 1}, 5};
  MergeList list;
  MergeEdit edit = Merge(1, 2, 1.0);
  edit.match.query = b;
  edit.match.pairs.resize(1);
  edit.match.pairs[0].other = a;
  list.Keep(std::move(edit));
  EXPECT_TRUE(list.HasJudged(a, b));
  EXPECT_TRUE(list.HasJudged(b, a));
  EXPECT_FALSE(list.HasJudged(b, c));
}

TEST(MergeList, CountsOverlapsOfTwoDrivesBothWays) {
  MergeList list;
  MergeEdit edit = Merge(1, 2, 1.0);
  edit.report.query.drive.robot = "a";
  edit.report.other.drive.robot = "b";
  list.Keep(edit);
  EXPECT_EQ(list.CountAccepted(edit.report.other.drive, edit.report.query.drive), 1);
  EXPECT_EQ(list.CountAccepted(edit.report.query.drive, edit.report.query.drive), 0);
}

TEST(MergeList, LendsTheSessionsOfAMapRootFirst) {
  const TwoDrives two = MakeTwoDrives();
  SessionTable table;
  table.Adopt(MappedSession(two, true, {}));
  const Session& a = table.Adopt(MappedSession(two, false, {}));
  MergeList list;
  list.Keep(Merge(2, 1, 1.0));
  list.Place();
  const std::vector<PlacedSession> placed = list.SessionsOf({1}, &table);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_EQ(placed[0].session, &a);
  EXPECT_TRUE(list.SessionsOf({2}, &table).empty());
}

}  // namespace
}  // namespace rovio_sfm
