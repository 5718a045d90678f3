#include "rovio_sfm/ros/frontend_thresholds.h"

#include <gtest/gtest.h>

#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

// The values of all parameters, by name, as text.
std::map<std::string, std::string> ValuesOf(const FrontendThresholdsConfig& thresholds) {
  std::map<std::string, std::string> values;
  for (const auto& parameter : FrontendThresholdsConfig::__getParamDescriptions__()) {
    boost::any value;
    parameter->getValue(thresholds, value);
    std::ostringstream text;
    if (const auto* number = boost::any_cast<double>(&value)) text << *number;
    if (const auto* count = boost::any_cast<int>(&value)) text << *count;
    if (const auto* flag = boost::any_cast<bool>(&value)) text << *flag;
    values[parameter->name] = text.str();
  }
  return values;
}

std::string ErrorOf(const FrontendThresholdsConfig& thresholds) {
  FrontendOptions widest;  // so that no other option stands in the way
  widest.track.remembered_frames = 10000;
  std::string error;
  return WithThresholds(widest, thresholds).IsValid(&error) ? "" : error;
}

TEST(FrontendThresholds, DefaultsAreTheOptions) {
  EXPECT_EQ(ValuesOf(ThresholdsOf({})), ValuesOf(FrontendThresholdsConfig::__getDefault__()));
}

TEST(FrontendThresholds, EveryThresholdReachesItsOption) {
  const FrontendThresholdsConfig lowest = FrontendThresholdsConfig::__getMin__();
  EXPECT_EQ(ValuesOf(ThresholdsOf(WithThresholds({}, lowest))), ValuesOf(lowest));
  const FrontendThresholdsConfig highest = FrontendThresholdsConfig::__getMax__();
  EXPECT_EQ(ValuesOf(ThresholdsOf(WithThresholds({}, highest))), ValuesOf(highest));
}

TEST(FrontendThresholds, BoundsAreThoseOfTheOptions) {
  EXPECT_EQ(ErrorOf(FrontendThresholdsConfig::__getMax__()), "");
  EXPECT_EQ(ErrorOf(FrontendThresholdsConfig::__getMin__()), "");
}

TEST(FrontendThresholds, OtherOptionsStay) {
  FrontendOptions options;
  options.choose.mode = KeyframeMode::kParallax;
  options.extract.type = DescriptorType::kOrb;
  FrontendThresholdsConfig thresholds = ThresholdsOf(options);
  thresholds.pair_min_inliers = 33;
  const FrontendOptions changed = WithThresholds(options, thresholds);
  EXPECT_EQ(changed.pair.verify.min_inliers, 33);
  EXPECT_EQ(changed.extract.type, DescriptorType::kOrb);
  EXPECT_TRUE(MayFollow(options, changed, nullptr));
}

}  // namespace
}  // namespace rovio_sfm
