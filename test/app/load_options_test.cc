#include "rovio_sfm/app/load_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "rovio_sfm/app/drive_tour_options.h"
#include "rovio_sfm/app/driver_options.h"
#include "rovio_sfm/app/frontend_node_options.h"
#include "rovio_sfm/app/mapping_node_options.h"
#include "rovio_sfm/app/place_recognition_node_options.h"

namespace rovio_sfm {
namespace {

// What the YAML makes of the options, not checked.
template <typename Options>
std::vector<std::string> EffectiveOf(const YAML::Node& node) {
  Options options;
  const OptionReader reader(node, "");
  LoadTable table(reader);
  options.DescribeOptions(table);
  table.EndGroup();
  return reader.Effective();
}

// The first option of the shipped file that is not the default; empty if there is none.
template <typename Options>
std::string FirstDifference(const std::string& name) {
  const auto a =
      EffectiveOf<Options>(YAML::LoadFile(std::string(ROVIO_SOURCE_DIR) + "/config/" + name));
  const auto b = EffectiveOf<Options>(YAML::Node());
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i] != b[i]) return a[i] + " against " + b[i];
  }
  return a.size() == b.size() ? "" : "another number of options";
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

TEST(LoadOptions, ShippedFilesHoldTheDefaults) {
  EXPECT_EQ(FirstDifference<FrontendOptions>("frontend.yaml"), "");
  EXPECT_EQ(FirstDifference<MapOptions>("mapping.yaml"), "");
  EXPECT_EQ(FirstDifference<PlaceRecognizerOptions>("place_recognition.yaml"), "");
  EXPECT_EQ(FirstDifference<DriverOptions>("rovio_driver.yaml"), "");
  EXPECT_EQ(FirstDifference<DriveTourOptions>("drive_tour.yaml"), "");
}

TEST(LoadOptions, FastFrontendIsReadWhole) {
  FrontendOptions options;
  LoadOptions(YAML::LoadFile(std::string(ROVIO_SOURCE_DIR) + "/config/frontend_fast.yaml"), "",
              &options);
  EXPECT_EQ(options.extract.max_features, 400);
  EXPECT_FALSE(options.extract.upsample);
}

TEST(LoadOptions, OutOfRangeNamesOptionAndBound) {
  MapOptions options;
  EXPECT_EQ(
      ErrorOf([&] { LoadOptions(YAML::Load("{resect: {min_inliers: 2}}"), "mapper", &options); }),
      "mapper.resect.min_inliers = 2: expected 6 to 1000");
}

TEST(LoadOptions, AnotherChoiceIsRefusedByName) {
  FrontendOptions options;
  EXPECT_EQ(ErrorOf([&] { LoadOptions(YAML::Load("{choose: {mode: no}}"), "", &options); }),
            "choose.mode: expected every or parallax, not 'no'");
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

TEST(LoadOptions, FrontendNodeTakesNoRelativeCalibration) {
  YAML::Node node;
  node["calibration_file"] = "camera.yaml";
  EXPECT_EQ(ErrorOf([&] { LoadFrontendNodeOptions(node, "/rovio1"); }),
            "calibration_file: 'camera.yaml': expected an absolute path");
}

TEST(LoadOptions, FrontendNodeRefusesUnknownParameters) {
  const YAML::Node node = YAML::Load("{frontend: {extract: {typ: orb}}}");
  EXPECT_EQ(ErrorOf([&] { LoadFrontendNodeOptions(node, "/rovio1"); }),
            "frontend.extract.typ: unknown key");
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
            "places.verify.pair.ratio: unknown key");
}

TEST(LoadOptions, MappingNodeReadsItsGroups) {
  const auto options =
      LoadMappingNodeOptions(YAML::Load("{robots: [a, b], mapper: {max_weak_frames: 7}}"));
  EXPECT_EQ(options.robots.size(), 2u);
  EXPECT_EQ(options.mapper.max_weak_frames, 7);
}

}  // namespace
}  // namespace rovio_sfm
