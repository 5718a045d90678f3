#include "rovio_sfm/features/extract_options.h"

#include <gtest/gtest.h>

#include <limits>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(ExtractOptions, DefaultsAreValid) {
  std::string error;
  EXPECT_TRUE(IsValid(ExtractOptions{}, &error)) << error;
}

TEST(ExtractOptions, NamesOptionValueAndBound) {
  ExtractOptions options;
  options.max_features = 5;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "max_features = 5: expected 16 to 20000");
}

TEST(ExtractOptions, RefusesNan) {
  ExtractOptions options;
  options.sift_contrast = std::numeric_limits<double>::quiet_NaN();
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
}

TEST(DescriptorTypeFromName, InvertsTheNameAndRefusesOthers) {
  EXPECT_EQ(DescriptorTypeFromName("akaze"), DescriptorType::kAkaze);
  EXPECT_EQ(NameOfDescriptorType(DescriptorType::kSurf), "surf");
  EXPECT_FALSE(DescriptorTypeFromName("none").has_value());
  EXPECT_FALSE(DescriptorTypeFromName("SIFT").has_value());
}

}  // namespace
}  // namespace rovio_sfm
