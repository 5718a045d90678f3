// Taking sessions out of their maps.
#include <gtest/gtest.h>

#include "merging/keeper_fixture.h"

namespace rovio_sfm {
namespace {

TEST(MapKeeperUndo, UndoesAForcedMergeToTheByte) {
  Sessions sessions;
  const std::string before = sessions.Bytes();
  sessions.keeper.MergeAt(sessions.a.id(), sessions.b.id(), {});
  EXPECT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.keeper.Unmerge(sessions.b.id()).size(), 1u);
  EXPECT_FALSE(sessions.InOneMap());
  EXPECT_EQ(sessions.Bytes(), before);
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  EXPECT_FALSE(sessions.InOneMap()) << "a place match joined what a request had separated";
}

TEST(MapKeeperUndo, UndoesAnAdjustedMergeToTheByte) {
  Sessions sessions(MakeTwoDrives(TwoDrivesOptions(0.7)));
  const std::string before = sessions.Bytes();
  sessions.keeper.Add(TrueOverlap(sessions.two, 8, 8));
  ASSERT_TRUE(sessions.InOneMap());
  EXPECT_EQ(sessions.Bytes(), before) << "the adjustment comes later";
  EXPECT_FALSE(sessions.keeper.Reports()[0].error_after_px);
  EXPECT_GT(sessions.keeper.Reports()[0].error_before_px, 0.1);
  sessions.PassKeyframes();
  EXPECT_NE(sessions.Bytes(), before);
  EXPECT_TRUE(sessions.keeper.Reports()[0].error_after_px);
  sessions.keeper.Unmerge(sessions.b.id());
  EXPECT_EQ(sessions.Bytes(), before);
}

TEST(MapKeeperUndo, UndoingKeepsAMergeOfOthersThatARequestMade) {
  MapOptions options;
  options.merge.automatic = false;
  ThreeSessions three(options);
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  ASSERT_EQ(three.keeper.Merge({1}, {2}, false).verdict, MergeVerdict::kAccepted);
  ASSERT_EQ(three.keeper.Merge({2}, {3}, false).verdict, MergeVerdict::kAccepted);
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  EXPECT_EQ(three.keeper.Reports().back().reason, "accepted by request");
}

TEST(MapKeeperUndo, UndoingKeepsAMergeOfOthersThatEvidenceMade) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  ASSERT_TRUE(three.AreInOneMap(three.a, three.c));
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  const MapPlace place = three.keeper.PlaceOf(three.c.id());
  EXPECT_EQ(place.map.value, 2u);
  EXPECT_NEAR(place.map_from_session.scale, OtherGauge().scale, 1e-6);
}

TEST(MapKeeperUndo, UndoingKeepsAMergeOfOthersThatAHandMade) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.MergeAt({2}, {3}, Inverse(OtherGauge()));
  ASSERT_EQ(three.keeper.Unmerge({1}).size(), 1u);
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
  EXPECT_EQ(three.keeper.PlaceOf({3}).map_from_session.scale, OtherGauge().scale);
}

// Whatever the merge that stayed apart from the undone one made, it is not touched.
TEST(MapKeeperUndo, UndoingOneSessionOfThreeGivesTheOthersTheirBytes) {
  ThreeSessions three;
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  const std::string before = BytesOf(three.b) + BytesOf(three.c);
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  ASSERT_TRUE(three.AreInOneMap(three.a, three.c));
  three.keeper.Unmerge({1});
  EXPECT_EQ(BytesOf(three.b) + BytesOf(three.c), before);
  EXPECT_TRUE(three.AreInOneMap(three.b, three.c));
}

// The adjustment that the undone merge threw away.
TEST(MapKeeperUndo, TheAdjustmentOfWhatRemainsBeginsAgain) {
  ThreeSessions three;
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Unmerge({1});
  ASSERT_FALSE(three.keeper.Reports()[0].error_after_px);
  for (int i = 0; i < 4; ++i) three.PassKeyframes();
  EXPECT_TRUE(three.keeper.Reports()[0].error_after_px);
}

// What was separated by request is not joined by way of a third session either.
TEST(MapKeeperUndo, NoPlaceMatchBringsASessionBackToTheOthersOfItsMap) {
  ThreeSessions three;
  three.keeper.Add(TrueOverlap(three.two, 8, 8));
  three.keeper.Add(three.OverlapOfThirdAndSecond());
  three.keeper.Unmerge({2});
  PlaceMatch later = three.OverlapOfThirdAndSecond();
  later.query.index = 9;
  three.keeper.Add(later);
  three.keeper.Add(TrueOverlap(three.two, 7, 7));
  EXPECT_FALSE(three.AreInOneMap(three.a, three.b));
  EXPECT_FALSE(three.AreInOneMap(three.b, three.c));
}

}  // namespace
}  // namespace rovio_sfm
