#include "rovio_sfm/app/option_pages.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

enum class Colour { kRed, kBlue };

struct InnerOptions {
  double length_m = 2.0;
  double share = 0.5;

  void DescribeOptions(OptionTable& table) {
    table.AddLiveNumber("length_m", length_m, 0.0, 9.0, "of it");
    table.AddRule("length_m", true, "at most the width");
    table.AddNumber("share", share, 0.0, 1.0, "");
  }
};

struct OuterOptions {
  std::string host;
  Colour colour = Colour::kBlue;
  InnerOptions inner;
  bool on = true;

  void DescribeOptions(OptionTable& table) {
    table.AddText("host", host, "of <robot>", OptionUse::kRequired);
    table.AddChoice("colour", colour, {{"red", Colour::kRed}, {"blue", Colour::kBlue}}, "of all");
    table.AddGroup("inner", inner, "inside");
    table.AddFlag("on", on, "works");
  }
};

TEST(YamlTable, WritesValuesWithTheirReasons) {
  OuterOptions options;
  YamlTable table;
  options.DescribeOptions(table);
  EXPECT_EQ(table.Text(),
            "colour: blue                  # red or blue; of all\n"
            "inner:                        # inside\n"
            "  length_m: 2.0               # of it\n"
            "  share: 0.5\n"
            "on: true                      # works\n");
}

TEST(MarkdownTable, WritesOneTableForEachGroup) {
  OuterOptions options;
  MarkdownTable table;
  options.DescribeOptions(table);
  const std::string head =
      "\n| option | default | unit | range | what it is |\n|---|---|---|---|---|\n";
  EXPECT_EQ(table.Text(),
            head +
                "| `host` |  |  |  | of \\<robot>; **must be set** |\n"
                "| `colour` | blue |  | red or blue | of all |\n"
                "| `on` | true |  |  | works |\n"
                "\n`inner`: inside\n" +
                head +
                "| `length_m` | 2 | m | 0 to 9; at most the width | of it; **live** |\n"
                "| `share` | 0.5 |  | 0 to 1 |  |\n");
}

TEST(MarkdownTable, LeavesOutWhatStandsElsewhere) {
  OuterOptions options;
  MarkdownTable table({"inner"});
  options.DescribeOptions(table);
  EXPECT_EQ(table.Text().find("length_m"), std::string::npos);
  EXPECT_NE(table.Text().find("colour"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
