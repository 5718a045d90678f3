#include "rovio_sfm/app/sensor_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

TEST(SensorOptions, LatencyOutOfRangeIsNamed) {
  SensorOptions options;
  options.odom_latency_s = 5.0;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("odom_latency_s"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
