#include "rovio_sfm/app/load_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "rovio_sfm/app/frontend_node_options.h"
#include "rovio_sfm/app/mapping_node_options.h"
#include "rovio_sfm/app/place_recognition_node_options.h"

namespace rovio_sfm {
namespace {

template <typename Options>
std::vector<std::string> EffectiveOf(const YAML::Node& node) {
  Options options;
  OptionReader reader(node, "");
  ReadOptions(&reader, &options);
  return reader.Effective();
}

// The first option that the two lists state differently; empty if there is none.
std::string FirstDifference(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i] != b[i]) return a[i] + " against " + b[i];
  }
  return "";
}

size_t NumScalars(const YAML::Node& node) {
  if (!node.IsMap()) return 1;
  size_t count = 0;
  for (const auto& entry : node) count += NumScalars(entry.second);
  return count;
}

YAML::Node ConfigFile(const std::string& name) {
  return YAML::LoadFile(std::string(ROVIO_SOURCE_DIR) + "/config/" + name);
}

template <typename Function>
std::string ErrorOf(const Function& function) {
  try {
    function();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LoadOptions, ShippedFrontendFileStatesEveryDefault) {
  const YAML::Node file = ConfigFile("frontend.yaml");
  const auto defaults = EffectiveOf<FrontendOptions>(YAML::Node());
  EXPECT_EQ(FirstDifference(EffectiveOf<FrontendOptions>(file), defaults), "");
  EXPECT_EQ(NumScalars(file), defaults.size());
}

TEST(LoadOptions, ShippedMappingFileStatesEveryDefault) {
  const YAML::Node file = ConfigFile("mapping.yaml");
  const auto defaults = EffectiveOf<MapOptions>(YAML::Node());
  EXPECT_EQ(FirstDifference(EffectiveOf<MapOptions>(file), defaults), "");
  EXPECT_EQ(NumScalars(file), defaults.size());
}

TEST(LoadOptions, ShippedPlaceRecognitionFileStatesEveryDefault) {
  const YAML::Node file = ConfigFile("place_recognition.yaml");
  const auto defaults = EffectiveOf<PlaceRecognizerOptions>(YAML::Node());
  EXPECT_EQ(FirstDifference(EffectiveOf<PlaceRecognizerOptions>(file), defaults), "");
  EXPECT_EQ(NumScalars(file), defaults.size());
}

TEST(LoadOptions, OutOfRangeNamesOptionAndBound) {
  const std::string error =
      ErrorOf([] { EffectiveOf<MapOptions>(YAML::Load("{resect: {min_inliers: 2}}")); });
  EXPECT_NE(error.find("min_inliers"), std::string::npos) << error;
}

TEST(LoadOptions, FrontendNodeTakesItsNameFromItsNamespace) {
  const auto options = LoadFrontendNodeOptions(YAML::Node(), "/rovio3");
  EXPECT_EQ(options.robot, "rovio3");
  EXPECT_EQ(options.sensors.base_frame, "rovio3/base_link");
}

TEST(LoadOptions, FrontendNodeRefusesToStartWithoutAName) {
  EXPECT_NE(ErrorOf([] { LoadFrontendNodeOptions(YAML::Node(), "/"); }).find("robot"),
            std::string::npos);
}

TEST(LoadOptions, FrontendNodeRefusesUnknownParameters) {
  const YAML::Node node = YAML::Load("{frontend: {extract: {typ: orb}}}");
  EXPECT_EQ(ErrorOf([&] { LoadFrontendNodeOptions(node, "/rovio1"); }),
            "frontend.extract.typ: unknown option");
}

TEST(LoadOptions, MappingNodeRefusesOddRobots) {
  const YAML::Node node = YAML::Load("{robots: [rovio1, Rovio 2]}");
  EXPECT_NE(ErrorOf([&] { LoadMappingNodeOptions(node); }).find("Rovio 2"), std::string::npos);
}

TEST(LoadOptions, PlaceRecognitionNodeReadsItsGroups) {
  const auto options = LoadPlaceRecognitionNodeOptions(
      YAML::Load("{robots: [a], cache_mb: 9, places: {seed: 4}, frontend: {min_features: 7}}"));
  EXPECT_EQ(options.cache_mb, 9);
  EXPECT_EQ(options.places.seed, 4u);
  EXPECT_EQ(options.frontend.min_features, 7);
}

TEST(LoadOptions, PlaceRecognitionNodeRefusesUnknownParameters) {
  const YAML::Node node = YAML::Load("{places: {verify: {pair: {ratio: 0.7}}}}");
  EXPECT_EQ(ErrorOf([&] { LoadPlaceRecognitionNodeOptions(node); }),
            "places.verify.pair.ratio: unknown option");
}

TEST(LoadOptions, MappingNodeReadsItsGroups) {
  const auto options =
      LoadMappingNodeOptions(YAML::Load("{robots: [a, b], mapper: {max_weak_frames: 7}}"));
  EXPECT_EQ(options.robots.size(), 2u);
  EXPECT_EQ(options.mapper.max_weak_frames, 7);
}

}  // namespace
}  // namespace rovio_sfm
