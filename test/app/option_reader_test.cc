#include "rovio_sfm/app/option_reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace rovio_sfm {
namespace {

std::string ErrorOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(OptionReader, ReadsFieldsAndKeepsDefaultsOfMissingOnes) {
  OptionReader reader(YAML::Load("{count: 3, length: 1, name: x, names: [a, b], on: true}"), "top");
  int count = 0;
  double length = 0.0, missing = 7.0;
  std::string name;
  std::vector<std::string> names;
  bool on = false;
  reader.Read("count", &count);
  reader.Read("length", &length);
  reader.Read("missing", &missing);
  reader.Read("name", &name);
  reader.Read("names", &names);
  reader.Read("on", &on);
  reader.RefuseUnknown();
  EXPECT_EQ(count, 3);
  EXPECT_EQ(length, 1.0);
  EXPECT_EQ(missing, 7.0);
  EXPECT_EQ(name, "x");
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(on);
}

TEST(OptionReader, NamesAnUnknownKeyWithItsPath) {
  OptionReader reader(YAML::Load("{inner: {odd: 1}}"), "top");
  OptionReader inner = reader.Group("inner");
  reader.RefuseUnknown();
  EXPECT_EQ(ErrorOf([&] { inner.RefuseUnknown(); }), "top.inner.odd: unknown key");
}

TEST(OptionReader, NamesAFieldOfAnotherType) {
  OptionReader reader(YAML::Load("{count: many}"), "top");
  int count = 0;
  EXPECT_EQ(ErrorOf([&] { reader.Read("count", &count); }),
            "top.count: expected a whole number, not 'many'");
}

TEST(OptionReader, RefusesANegativeNumberWhereNoneIsMeant) {
  OptionReader reader(YAML::Load("{seed: -1}"), "");
  uint64_t seed = 0;
  EXPECT_EQ(ErrorOf([&] { reader.Read("seed", &seed); }),
            "seed: expected a whole number, 0 or more, not '-1'");
}

TEST(OptionReader, RefusesAScalarForAGroup) {
  OptionReader reader(YAML::Load("{inner: 3}"), "top");
  EXPECT_EQ(ErrorOf([&] { reader.Group("inner"); }), "top.inner: expected a mapping");
}

TEST(OptionReader, MissingGroupIsEmpty) {
  OptionReader reader(YAML::Node(), "top");
  OptionReader inner = reader.Group("inner");
  int count = 5;
  inner.Read("count", &count);
  inner.RefuseUnknown();
  EXPECT_EQ(count, 5);
}

TEST(OptionReader, TellsTheEffectiveOptionsOfAllGroups) {
  OptionReader reader(YAML::Load("{inner: {count: 3}}"), "");
  int count = 0;
  bool on = true;
  reader.Group("inner").Read("count", &count);
  reader.Read("on", &on);
  EXPECT_EQ(reader.Effective(), (std::vector<std::string>{"inner.count = 3", "on = true"}));
}

}  // namespace
}  // namespace rovio_sfm
