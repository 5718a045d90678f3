#include "rovio_sfm/util/option_text.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

template <typename Value>
std::string PlainText(Value value) {
  return TextOf(OptionValue(&value));
}

template <typename Value>
std::string YamlText(Value value) {
  return YamlTextOf(OptionValue(&value));
}

TEST(TextOf, IsTheShortestThatReadsBackTheSame) {
  EXPECT_EQ(PlainText(3.0), "3");
  EXPECT_EQ(PlainText(0.9f), "0.9");
  EXPECT_EQ(PlainText(2.0 / 3.0), "0.6666666666666666");
  EXPECT_EQ(PlainText(1e-5), "1e-05");
  EXPECT_EQ(PlainText(1e9), "1000000000");
  EXPECT_EQ(PlainText(32000000), "32000000");
  EXPECT_EQ(PlainText(true), "true");
  EXPECT_EQ(PlainText(std::vector<std::string>{"a", "b"}), "[a, b]");
}

TEST(YamlTextOf, IsOfTheTypeOfItsField) {
  EXPECT_EQ(YamlText(3), "3");
  EXPECT_EQ(YamlText(3.0), "3.0");
  EXPECT_EQ(YamlText(1e-5), "1.0e-05");
  EXPECT_EQ(YamlText(-0.5), "-0.5");
  EXPECT_EQ(YamlText(std::string()), "\"\"");
  EXPECT_EQ(YamlText(std::string("rovio_640x480")), "rovio_640x480");
  EXPECT_EQ(YamlText(std::string("two words")), "\"two words\"");
  EXPECT_EQ(YamlText(std::vector<double>{1.0, 0.25}), "[1.0, 0.25]");
}

TEST(RangeText, SaysBoundsOrChoices) {
  EXPECT_EQ(RangeText({"a", "", OptionUse::kAtStart, 0.1, 100000.0}), "0.1 to 100000");
  EXPECT_EQ(RangeText({"a", "", OptionUse::kAtStart, 0.0, kNoLimit}), "0 or more");
  EXPECT_EQ(RangeText({"a", ""}), "");
  OptionRow row{"a", ""};
  row.choices = {"sift", "orb", "surf"};
  EXPECT_EQ(RangeText(row), "sift, orb or surf");
}

TEST(UnitOf, IsTheEndOfTheName) {
  EXPECT_EQ(UnitOf("max_error_px"), "px");
  EXPECT_EQ(UnitOf("min_speed_m_per_s"), "m/s");
  EXPECT_EQ(UnitOf("max_rotation_gap_deg"), "°");
  EXPECT_EQ(UnitOf("max_features"), "");
}

}  // namespace
}  // namespace rovio_sfm
