#include "rovio_sfm/util/package_file.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(FindPackageFile, FindsWhatComesWithThePackage) {
  const auto file = FindPackageFile("config/places/indoor.places");
  ASSERT_TRUE(file);
  EXPECT_TRUE(std::filesystem::is_regular_file(*file));
}

TEST(FindPackageFile, IsNothingForAFileThatDoesNotCome) {
  EXPECT_FALSE(FindPackageFile("config/no_such_file.yaml"));
}

}  // namespace
}  // namespace rovio_sfm
