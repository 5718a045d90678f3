#include "rovio_sfm/util/text_ends.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(TextEnds, TellHowATextStartsAndEnds) {
  EXPECT_TRUE(StartsWith("/api/cloud", "/api/"));
  EXPECT_FALSE(StartsWith("/ap", "/api/"));
  EXPECT_FALSE(StartsWith("x/api/", "/api/"));
  EXPECT_TRUE(EndsWith("image/compressed", "/compressed"));
  EXPECT_FALSE(EndsWith("compressed", "/compressed"));
  EXPECT_FALSE(EndsWith("image/compressed/", "/compressed"));
}

TEST(TextEnds, NothingStartsAndEndsEveryText) {
  EXPECT_TRUE(StartsWith("", "") && EndsWith("", ""));
  EXPECT_TRUE(StartsWith("a", "") && EndsWith("a", ""));
}

}  // namespace
}  // namespace rovio_sfm
