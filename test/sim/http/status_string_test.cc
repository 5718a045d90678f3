#include "rovio_sfm/sim/http/status_string.h"

#include <gtest/gtest.h>

#include <climits>

namespace rovio_sfm::sim {
namespace {

TEST(FormatStatus, HasItsFieldsInPlace) {
  RobotSnapshot snapshot;
  snapshot.settings.resolution = 3;
  snapshot.picture_index = 42;
  snapshot.picture_bytes = 12345;
  snapshot.is_checking_users = true;
  snapshot.mcu.battery = 0x7F;
  const std::string status = FormatStatus(snapshot);
  ASSERT_EQ(status.size(), 96u);
  EXPECT_EQ(status.substr(15, 3), "006");
  EXPECT_EQ(status.substr(21, 3), "310");
  EXPECT_EQ(status.substr(24, 6), "000042");
  EXPECT_EQ(status.substr(31, 1), "1");
  EXPECT_EQ(status.substr(32, 8), "00012345");
  EXPECT_EQ(status.substr(82, 3), "030");
  EXPECT_EQ(status.substr(85, 6), "015015");
  EXPECT_EQ(status.substr(92, 2), "d4");
  EXPECT_EQ(status.substr(94, 2), "7f");
}

TEST(FormatStatus, KeepsItsLengthWithWildSettings) {
  RobotSnapshot snapshot;
  snapshot.settings.resolution = LONG_MAX;
  snapshot.settings.brightness = LONG_MIN;
  snapshot.settings.frame_rate_hz = 123456;
  EXPECT_EQ(FormatStatus(snapshot).size(), 96u);
}

}  // namespace
}  // namespace rovio_sfm::sim
