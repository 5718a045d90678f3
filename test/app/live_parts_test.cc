#include "rovio_sfm/app/live_parts.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

using Names = std::vector<std::string>;

TEST(LiveParts, TellsWhatChangedSinceARevision) {
  LiveParts parts;
  parts.Set("scene/a", "1");
  parts.Set("scene/b", "2");
  parts.Set("status", "3");
  const auto all = parts.ChangesSince(0, "scene/");
  ASSERT_TRUE(all);
  EXPECT_EQ(all->names, (Names{"scene/a", "scene/b"}));
  EXPECT_EQ(all->changed.size(), 2u);
  parts.Set("scene/b", "4");
  const auto next = parts.ChangesSince(all->revision, "scene/");
  ASSERT_TRUE(next);
  EXPECT_EQ(next->names, (Names{"scene/a", "scene/b"}));
  ASSERT_EQ(next->changed.size(), 1u);
  EXPECT_EQ(*next->changed.at("scene/b").bytes, "4");
  EXPECT_FALSE(parts.ChangesSince(next->revision, "scene/"));
}

TEST(LiveParts, TheSameBytesAreNoChange) {
  LiveParts parts;
  parts.Set("scene/a", "1");
  const uint64_t revision = parts.Find("scene/a")->revision;
  parts.Set("scene/a", "1");
  EXPECT_EQ(parts.Find("scene/a")->revision, revision);
  EXPECT_FALSE(parts.ChangesSince(revision, ""));
}

TEST(LiveParts, APartThatWentIsAChange) {
  LiveParts parts;
  parts.Set("scene/a", "1");
  parts.Set("scene/b", "1");
  parts.Set("status", "1");
  const uint64_t before = parts.Find("status")->revision;
  parts.Erase("scene/a");
  const auto changes = parts.ChangesSince(before, "scene/");
  ASSERT_TRUE(changes);
  EXPECT_EQ(changes->names, Names{"scene/b"});
  EXPECT_TRUE(changes->changed.empty());
  EXPECT_FALSE(parts.ChangesSince(before, "status"));
  parts.EraseAll("scene/");
  EXPECT_FALSE(parts.Find("scene/b"));
  EXPECT_TRUE(parts.Find("status"));
  parts.Erase("scene/b");
  EXPECT_EQ(parts.ChangesSince(before, "scene/")->names, Names{});
}

TEST(LiveParts, BytesOutliveTheirPart) {
  LiveParts parts;
  parts.Set("cloud", "points");
  const LivePart part = *parts.Find("cloud");
  parts.Erase("cloud");
  EXPECT_EQ(*part.bytes, "points");
}

}  // namespace
}  // namespace rovio_sfm
