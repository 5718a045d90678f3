#include "rovio_sfm/sim/http/nav_report.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(FormatNavReport, ShowsFlagsAsFourHexDigits) {
  RobotSnapshot snapshot;
  snapshot.nav.home_saved = snapshot.mcu.obstacle = snapshot.mcu.infrared = true;
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|flags=0007\n"));
}

TEST(FormatNavReport, ShowsChargingAsBitsOfTheStatus) {
  RobotSnapshot snapshot;
  snapshot.mcu.on_dock = true;
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|charging=64|"));
  snapshot.mcu.charge_complete = true;
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|charging=72|"));
  snapshot.mcu.charge_complete = false;
  snapshot.mcu.charging = true;
  snapshot.mcu.headlight = true;
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|charging=80|"));
}

TEST(FormatNavReport, ShowsTheCallerAndTheMains) {
  RobotSnapshot snapshot;
  snapshot.caller_privilege = Privilege::kUser;
  snapshot.settings.mains_frequency_hz = 0;
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|privilege=1|user_check=0|"));
  EXPECT_TRUE(Contains(FormatNavReport(snapshot), "|ac_freq=0"));
}

}  // namespace
}  // namespace rovio_sfm::sim
