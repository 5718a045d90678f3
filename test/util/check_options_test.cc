#include "rovio_sfm/util/check_options.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

enum class Colour { kRed, kBlue, kNone };

struct InnerOptions {
  int size = 3;
  float ratio = 0.1f;
  Colour colour = Colour::kRed;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("size", size, 1, 9, "of it");
    table.AddNumber("ratio", ratio, 0.1, 1.0, "one to the other");
    table.AddChoice("colour", colour, {{"red", Colour::kRed}, {"blue", Colour::kBlue}}, "of it");
  }
};

struct OuterOptions {
  double share = 0.5;
  uint64_t seed = 1;
  double angle_rad = 0.5;
  int64_t pause_ns = 1'500'000'000;
  std::array<int, 3> signs = {1, 1, 1};
  InnerOptions inner;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("share", share, 0.0, 1.0, "of all");
    table.AddNumber("seed", seed, 0, kNoLimit, "of chance");
    table.AddDegrees("angle_deg", angle_rad, -90.0, 90.0, "to the left");
    table.AddSeconds("pause_s", pause_ns, 0.0, 10.0, "between two");
    table.AddNumbers("signs", signs, -1, 1, "of the wheels");
    table.AddGroup("inner", inner, "what is inside");
    table.AddRule("share", share <= inner.size, "at most inner.size");
  }
};

TEST(FirstComplaint, IsEmptyForOptionsThatFit) {
  EXPECT_EQ(FirstComplaint(OuterOptions{}), "");
  std::string error = "none yet";
  EXPECT_TRUE(IsValid(OuterOptions{}, &error));
  EXPECT_EQ(error, "none yet");
  EXPECT_NO_THROW(RequireValid(OuterOptions{}));
}

TEST(FirstComplaint, NamesPathValueAndBounds) {
  OuterOptions options;
  options.inner.size = 0;
  options.inner.ratio = 2.0f;  // not the first
  EXPECT_EQ(FirstComplaint(options), "inner.size = 0: expected 1 to 9");
  EXPECT_EQ(FirstComplaint(options, "outer"), "outer.inner.size = 0: expected 1 to 9");
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "inner.size = 0: expected 1 to 9");
  EXPECT_FALSE(IsValid(options));
  EXPECT_THROW(RequireValid(options), std::runtime_error);
}

TEST(FirstComplaint, AllowsTheBoundsButNeverNan) {
  OuterOptions options;
  for (const double bound : {0.0, 1.0}) {
    options.share = bound;
    EXPECT_EQ(FirstComplaint(options), "");
  }
  options.share = std::nan("");
  EXPECT_EQ(FirstComplaint(options), "share = nan: expected 0 to 1");
}

TEST(FirstComplaint, SaysConvertedValuesInTheirShownUnit) {
  OuterOptions options;
  options.angle_rad = 2.0 * M_PI / 3.0;
  EXPECT_EQ(FirstComplaint(options), "angle_deg = 120: expected -90 to 90");
  options.angle_rad = 0.0;
  options.pause_ns = 10'250'000'000;
  EXPECT_EQ(FirstComplaint(options), "pause_s = 10.25: expected 0 to 10");
}

TEST(FirstComplaint, NamesTheChoices) {
  InnerOptions options;
  options.colour = Colour::kNone;
  EXPECT_EQ(FirstComplaint(options), "colour = : expected red or blue");
}

TEST(FirstComplaint, LooksAtEveryNumberOfAList) {
  OuterOptions options;
  options.signs = {1, -1, 2};
  EXPECT_EQ(FirstComplaint(options), "signs = [1, -1, 2]: expected -1 to 1");
}

TEST(FirstComplaint, AppliesRulesBetweenOptions) {
  struct RuledOptions : OuterOptions {
    void DescribeOptions(OptionTable& table) {
      table.AddNumber("share", share, 0.0, 1.0, "of all");
      table.AddRule("share", share < 0.3, "below 0.3");
    }
  };
  EXPECT_EQ(FirstComplaint(RuledOptions{}), "share = 0.5: expected below 0.3");
}

// Sets every number it sees.
class SetTable : public OptionTable {
 private:
  void VisitOption(const OptionRow& row, OptionValue value) override {
    if (auto** number = std::get_if<double*>(&value)) **number = row.high;
    if (auto** text = std::get_if<std::string*>(&value)) **text = row.choices.back();
    if (auto** list = std::get_if<std::vector<int>*>(&value)) (*list)->assign({-1, 0, 1});
  }
};

TEST(OptionTable, ChangesReachTheFieldsInTheirOwnUnit) {
  OuterOptions options;
  SetTable table;
  options.DescribeOptions(table);
  EXPECT_EQ(options.share, 1.0);
  EXPECT_NEAR(options.angle_rad, M_PI / 2.0, 1e-15);
  EXPECT_EQ(options.pause_ns, 10'000'000'000);
  EXPECT_EQ(options.signs, (std::array<int, 3>{-1, 0, 1}));
  EXPECT_EQ(options.inner.colour, Colour::kBlue);
}

}  // namespace
}  // namespace rovio_sfm
