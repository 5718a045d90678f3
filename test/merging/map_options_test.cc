#include "rovio_sfm/merging/map_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(MapOptions, RefuseBadPartsByTheirName) {
  std::string error;
  EXPECT_TRUE(IsValid(MapOptions{}, &error)) << error;
  MapOptions bad_drive;
  bad_drive.max_weak_tries = 0;
  EXPECT_FALSE(IsValid(bad_drive, &error));
  EXPECT_NE(error.find("max_weak_tries"), std::string::npos) << error;
  MapOptions bad_merge;
  bad_merge.merge.patience = 0;
  EXPECT_FALSE(IsValid(bad_merge, &error));
  EXPECT_NE(error.find("patience"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
