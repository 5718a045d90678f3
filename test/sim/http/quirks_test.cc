#include "rovio_sfm/sim/http/quirks.h"

#include <gtest/gtest.h>

#include <set>

namespace rovio_sfm::sim {
namespace {

TEST(Quirks, AllHaveTheirOwnNameAndAreOffAtFirst) {
  Quirks quirks;
  std::set<std::string_view> names;
  for (size_t i = 0; i < kNumQuirks; ++i) {
    EXPECT_EQ(static_cast<size_t>(AllQuirks()[i].quirk), i);
    names.insert(AllQuirks()[i].name);
    EXPECT_EQ(quirks.Value(AllQuirks()[i].quirk), 0.0);
    EXPECT_FALSE(quirks.IsActive(AllQuirks()[i].quirk, 0));
    EXPECT_FALSE(quirks.Strikes(AllQuirks()[i].quirk));
  }
  EXPECT_EQ(names.size(), kNumQuirks);
}

TEST(Quirks, TimedOnesEndByThemselves) {
  Quirks quirks;
  std::string error;
  ASSERT_TRUE(quirks.Set("stall", 10.0, 1'000, &error));
  EXPECT_TRUE(quirks.IsActive(Quirk::kStall, 10'000'000'999));
  EXPECT_FALSE(quirks.IsActive(Quirk::kStall, 10'000'001'000));
}

TEST(Quirks, EveryThirdEventIsStruck) {
  Quirks quirks;
  std::string error;
  ASSERT_TRUE(quirks.Set("truncate_jpeg", 3.0, 0, &error));
  std::string struck;
  for (int i = 0; i < 6; ++i) struck += quirks.Strikes(Quirk::kTruncateJpeg) ? 'x' : '.';
  EXPECT_EQ(struck, "..x..x");
}

TEST(Quirks, NoneSwitchesAllOff) {
  Quirks quirks;
  std::string error;
  ASSERT_TRUE(quirks.Set("slow_nav", 1.0, 0, &error));
  ASSERT_TRUE(quirks.Set("none", 0.0, 0, &error));
  EXPECT_EQ(quirks.Value(Quirk::kSlowNav), 0.0);
}

TEST(Quirks, RefusesUnknownNamesAndValuesOutOfRange) {
  Quirks quirks;
  std::string error;
  EXPECT_FALSE(quirks.Set("stal", 1.0, 0, &error));
  EXPECT_EQ(error, "no quirk is called stal");
  EXPECT_FALSE(quirks.Set("stall", -1.0, 0, &error));
  EXPECT_NE(error.find("quirk stall = -1"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
