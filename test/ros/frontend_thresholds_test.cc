#include "rovio_sfm/ros/frontend_thresholds.h"

#include <dynamic_reconfigure/config_tools.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigTools;

// The values of all thresholds, by name.
std::map<std::string, double> ValuesOf(const FrontendThresholdsConfig& thresholds) {
  Config message;
  thresholds.__toMessage__(message);
  std::map<std::string, double> values;
  for (const auto& flag : message.bools) values[flag.name] = flag.value;
  for (const auto& count : message.ints) values[count.name] = count.value;
  for (const auto& number : message.doubles) values[number.name] = number.value;
  return values;
}

std::string ErrorOf(const FrontendThresholdsConfig& thresholds) {
  FrontendOptions widest;  // so that no other option stands in the way
  widest.track.remembered_frames = 10000;
  return FirstComplaint(WithThresholds(widest, thresholds));
}

template <typename Value>
FrontendThresholdsConfig Changed(const std::string& name, Value value) {
  Config message;
  ConfigTools::appendParameter(message, name, value);
  FrontendThresholdsConfig thresholds;
  thresholds.__fromMessage__(message);
  return thresholds;
}

TEST(FrontendThresholds, AreNamedByTheirPaths) {
  const auto values = ValuesOf(FrontendThresholdsConfig());
  EXPECT_EQ(values.size(), 27u);
  EXPECT_EQ(values.at("min_features"), 20.0);
  EXPECT_EQ(values.at("recursion_max_frames"), 8.0);
  EXPECT_EQ(values.at("pair_use_guided"), 1.0);
  EXPECT_EQ(values.at("pair_verify_threshold_px"), 1.5);
  EXPECT_NEAR(values.at("pair_max_ratio"), 0.9, 1e-6);  // a float
}

TEST(FrontendThresholds, EveryThresholdReachesItsOption) {
  const FrontendThresholdsConfig lowest = FrontendThresholdsConfig::__getMin__();
  EXPECT_EQ(ValuesOf(FrontendThresholdsConfig(WithThresholds({}, lowest))), ValuesOf(lowest));
  const FrontendThresholdsConfig highest = FrontendThresholdsConfig::__getMax__();
  EXPECT_EQ(ValuesOf(FrontendThresholdsConfig(WithThresholds({}, highest))), ValuesOf(highest));
  for (const auto& [name, low] : ValuesOf(lowest)) {
    EXPECT_LT(low, ValuesOf(highest).at(name)) << name;
  }
}

TEST(FrontendThresholds, BoundsAreThoseOfTheOptions) {
  EXPECT_EQ(ErrorOf(FrontendThresholdsConfig::__getMax__()), "");
  EXPECT_EQ(ErrorOf(FrontendThresholdsConfig::__getMin__()), "");
}

TEST(FrontendThresholds, AreClampedToTheirBounds) {
  FrontendThresholdsConfig thresholds = Changed("recursion_max_frames", 1000);
  EXPECT_EQ(ValuesOf(thresholds).at("recursion_max_frames"), 1000.0);
  thresholds.__clamp__();
  EXPECT_EQ(ValuesOf(thresholds).at("recursion_max_frames"), 100.0);
}

TEST(FrontendThresholds, OtherOptionsStay) {
  FrontendOptions options;
  options.choose.mode = KeyframeMode::kParallax;
  options.extract.type = DescriptorType::kOrb;
  const FrontendOptions changed = WithThresholds(options, Changed("pair_verify_min_inliers", 33));
  EXPECT_EQ(changed.pair.verify.min_inliers, 33);
  EXPECT_EQ(changed.extract.type, DescriptorType::kOrb);
  EXPECT_TRUE(MayFollow(options, changed, nullptr));
}

TEST(FrontendThresholds, DescribeThemselves) {
  const auto description = FrontendThresholdsConfig::__getDescriptionMessage__();
  ASSERT_EQ(description.groups.size(), 1u);
  ASSERT_EQ(description.groups[0].parameters.size(), 27u);
  EXPECT_EQ(description.groups[0].parameters[0].name, "min_features");
  EXPECT_EQ(description.groups[0].parameters[0].type, "int");
  EXPECT_EQ(description.groups[0].parameters[0].description, "images with fewer are dropped");
  EXPECT_EQ(description.max.ints.size(), description.dflt.ints.size());
}

}  // namespace
}  // namespace rovio_sfm
