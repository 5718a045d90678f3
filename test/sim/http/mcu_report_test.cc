#include "rovio_sfm/sim/http/mcu_report.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(FormatMcuReport, PlacesWheelsHeadBatteryAndStatus) {
  McuReading reading;
  reading.left = {0x05, 0x1234};
  reading.right = {0x02, 0x00FF};
  reading.rear = {0x05, 0xABCD};
  reading.head_position = 0x41;
  reading.battery = 0x7E;
  reading.obstacle = true;
  EXPECT_EQ(FormatMcuReport(reading),
            "0E01"
            "051234"
            "0200FF"
            "05ABCD"
            "03"
            "41"
            "7E"
            "04");
}

TEST(McuStatusByte, HasOneBitForEachState) {
  McuReading reading;
  EXPECT_EQ(McuStatusByte(reading), 0x00);
  reading.charging = reading.on_dock = true;
  EXPECT_EQ(McuStatusByte(reading), 0x50);
  reading.charger_error = true;
  EXPECT_EQ(McuStatusByte(reading), 0x70);
}

}  // namespace
}  // namespace rovio_sfm::sim
