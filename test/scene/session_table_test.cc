#include "rovio_sfm/scene/session_table.h"

#include <gtest/gtest.h>

#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

Keyframe EmptyKeyframe() { return {}; }

TEST(SessionTable, NumbersSessionsInTheOrderInWhichTheyOpen) {
  SessionTable table;
  const Camera camera = MakeSyntheticCamera();
  EXPECT_EQ(table.Open({"a", 1, 0}, camera).id().value, 1u);
  table.Adopt(Session({7}, {"b", 1, 0}, camera));
  EXPECT_EQ(table.Open({"a", 1, 0}, camera).id().value, 8u);
  EXPECT_EQ(table.all().size(), 3u);
  EXPECT_EQ(table.Find({2}), nullptr);
  EXPECT_EQ(table.Lend({7})->drive().robot, "b");
}

TEST(SessionTable, FindsTheHolderOfAFrameThatHasAPose) {
  SessionTable table;
  const DriveId drive{"a", 1, 0};
  Session& first = table.Open(drive, MakeSyntheticCamera());
  Session& second = table.Open(drive, MakeSyntheticCamera());
  first.AddKeyframe(0, EmptyKeyframe());
  second.AddKeyframe(5, EmptyKeyframe());
  EXPECT_EQ(table.FindHolder({drive, 5}), &second);
  EXPECT_EQ(table.FindHolder({drive, 4}), nullptr);
  EXPECT_EQ(table.FindHolder({{"b", 1, 0}, 5}), nullptr);
  second.SetWeak(5, true);
  EXPECT_EQ(table.FindHolder({drive, 5}), nullptr);
}

TEST(SessionTableDeathTest, RefusesTwoSessionsWithOneId) {
  SessionTable table;
  table.Adopt(Session({1}, {"a", 1, 0}, MakeSyntheticCamera()));
  EXPECT_DEATH(table.Adopt(Session({1}, {"b", 1, 0}, MakeSyntheticCamera())), "one id");
}

}  // namespace
}  // namespace rovio_sfm
