#include "rovio_sfm/sim/world/yaml_map.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace rovio_sfm::sim {
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
  EXPECT_EQ(MessageOf([] { Map("{a: 1}").Number("b"); }), "here: key b is missing");
}

TEST(YamlMap, NamesTheUnknownKey) {
  EXPECT_EQ(MessageOf([] { Map("{a: 1}").RefuseUnknownKeys(); }), "here: unknown key a");
}

TEST(YamlMap, RefusesWhatIsNoFiniteNumber) {
  EXPECT_NE(MessageOf([] { Map("{a: x}").Number("a"); }), "");
  EXPECT_NE(MessageOf([] { Map("{a: .nan}").Number("a"); }), "");
  EXPECT_NE(MessageOf([] { Map("{a: [1, .inf]}").Numbers("a", 2); }), "");
}

TEST(YamlMap, RefusesAKeyThatStandsTwice) {
  EXPECT_NE(MessageOf([] { Map("{a: 1, a: 2}"); }), "");
}

TEST(YamlMap, TurnsAPlacementByYaw) {
  const Rigid3 placement = Map("{at_m: [1, 2, 3], yaw_deg: 90}").Placement();
  const Eigen::Vector3d moved = placement * Eigen::Vector3d(1, 0, 0);
  EXPECT_NEAR((moved - Eigen::Vector3d(1, 3, 3)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace rovio_sfm::sim
