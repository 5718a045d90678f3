#include "rovio_sfm/sim/http/parameters.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(Parameters, DecodesNamesAndValues) {
  const auto parameters = Parameters::Parse("Cmd=nav&na%6De=a+b%20c%26&&flag&empty=");
  EXPECT_EQ(parameters.Get("Cmd"), "nav");
  EXPECT_EQ(parameters.Get("name"), "a b c&");
  EXPECT_TRUE(parameters.Has("flag"));
  EXPECT_TRUE(parameters.Has("empty"));
  EXPECT_FALSE(parameters.Has("absent"));
}

TEST(Parameters, FirstOfARepeatedNameCounts) {
  EXPECT_EQ(Parameters::Parse("a=1&a=2").Get("a"), "1");
}

TEST(Parameters, NumbersMustBeWholeAndInRange) {
  const auto parameters = Parameters::Parse("a=-12&b=12x&c=&d=99999999999999999999");
  EXPECT_EQ(parameters.GetLong("a"), -12);
  EXPECT_EQ(parameters.GetLong("b"), std::nullopt);
  EXPECT_EQ(parameters.GetLong("c"), std::nullopt);
  EXPECT_EQ(parameters.GetLong("d"), std::nullopt);
  EXPECT_EQ(ParseDouble("0.5"), 0.5);
  EXPECT_EQ(ParseDouble("nan"), std::nullopt);
  EXPECT_EQ(ParseDouble("1e999"), std::nullopt);
  EXPECT_EQ(ParseDouble(""), std::nullopt);
}

TEST(Parameters, TruthHasManyNames) {
  const auto parameters = Parameters::Parse("a=true&b=1&c=Yes&d=false&e=0&f=");
  EXPECT_TRUE(parameters.GetBool("a"));
  EXPECT_TRUE(parameters.GetBool("b"));
  EXPECT_TRUE(parameters.GetBool("c"));
  EXPECT_FALSE(parameters.GetBool("d"));
  EXPECT_FALSE(parameters.GetBool("e"));
  EXPECT_FALSE(parameters.GetBool("f"));
}

TEST(Parameters, MalformedEscapesStay) {
  EXPECT_EQ(DecodeUrl("%zz%4", true), "%zz%4");
  EXPECT_EQ(DecodeUrl("a+b", false), "a+b");
}

TEST(SplitCommands, CutsBeforeEachCommand) {
  EXPECT_EQ(SplitCommands("Cmd=nav&action=1&Cmd=GetVer.cgi"),
            (std::vector<std::string>{"Cmd=nav&action=1", "Cmd=GetVer.cgi"}));
  EXPECT_EQ(SplitCommands(""), std::vector<std::string>{""});
}

}  // namespace
}  // namespace rovio_sfm::sim
