#include "rovio_sfm/util/yaml_map.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace rovio_sfm {
namespace {

YamlMap Map(const std::string& yaml) { return YamlMap(YAML::Load(yaml), "here"); }

std::string MessageOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(YamlMap, ReadsNumbersTextsAndLists) {
  YamlMap map = Map("{a: 1.5, b: word, c: [1, 2], d: [{e: 1}]}");
  EXPECT_EQ(map.Number("a"), 1.5);
  EXPECT_EQ(map.Text("b"), "word");
  EXPECT_EQ(map.Numbers("c", 2)[1], 2.0);
  EXPECT_EQ(map.List("d").size(), 1u);
  EXPECT_NO_THROW(map.RefuseUnknownKeys());
}

TEST(YamlMap, NamesTheMissingKey) {
  EXPECT_EQ(MessageOf([] { Map("{a: 1}").Number("b"); }), "here.b: missing");
}

TEST(YamlMap, NamesTheUnknownKey) {
  EXPECT_EQ(MessageOf([] { Map("{a: 1}").RefuseUnknownKeys(); }), "here.a: unknown key");
}

TEST(YamlMap, RefusesWhatIsNoFiniteNumber) {
  EXPECT_NE(MessageOf([] { Map("{a: x}").Number("a"); }), "");
  EXPECT_NE(MessageOf([] { Map("{a: .nan}").Number("a"); }), "");
  EXPECT_NE(MessageOf([] { Map("{a: [1, .inf]}").Numbers("a", 2); }), "");
}

TEST(YamlMap, TakesWholeNumbersAsDecimalOnly) {
  EXPECT_EQ(Map("{a: -12}").Integer("a", 1), -12);
  EXPECT_EQ(Map("{a: 0}").Integer("a", 1), 0);
  for (const std::string text : {"0777", "0x10", "1.5", "1e3", "-", "''"}) {
    YamlMap map = Map("{a: " + text + "}");
    const std::string shown = text == "''" ? text : "'" + text + "'";
    EXPECT_EQ(MessageOf([&] { map.Integer("a", 1); }),
              "here.a: expected a whole number, not " + shown);
  }
  std::vector<int> values;
  EXPECT_EQ(MessageOf([&] { Map("{a: [1, 010]}").Read("a", "whole numbers", &values); }),
            "here.a: expected whole numbers, not a list");
}

TEST(YamlMap, TakesNoNegativeForAnUnsigned) {
  EXPECT_EQ(MessageOf([] { Map("{a: -1}").Seed("a", 1); }),
            "here.a: expected a whole number, 0 or more, not '-1'");
}

TEST(YamlMap, RefusesAKeyThatStandsTwice) {
  EXPECT_EQ(MessageOf([] { Map("{a: 1, a: 2}"); }), "here.a: stands twice");
}

TEST(YamlMap, TellsWhereAFaultLies) {
  YamlMap file(YAML::Load("{d: [{e: 1}, {e: x, f: 2}], g: {h: 1}, i: 3}"), "file", ": ");
  YamlMap item = file.List("d")[1];
  EXPECT_EQ(MessageOf([&] { item.Number("e"); }), "file: d[1].e: expected a number, not 'x'");
  EXPECT_EQ(MessageOf([&] { item.RefuseUnknownKeys(); }), "file: d[1].f: unknown key");
  EXPECT_EQ(MessageOf([&] { file.Group("g").Text("k"); }), "file: g.k: missing");
  EXPECT_EQ(MessageOf([&] { file.Group("i"); }), "file: i: expected a mapping");
}

TEST(YamlMap, IsEmptyWithoutANode) {
  YamlMap map(YAML::Node(), "here");
  EXPECT_FALSE(map.Has("a"));
  EXPECT_EQ(map.Number("a", 2.0), 2.0);
  EXPECT_NO_THROW(map.Group("b").RefuseUnknownKeys());
}

}  // namespace
}  // namespace rovio_sfm
