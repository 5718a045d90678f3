#include "rovio_sfm/sim/http/nav_report.h"

#include <cstdio>

#include "rovio_sfm/sim/http/mcu_report.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kIdleStateMachine = 15;  // `sm` of a robot at rest, in every sample known
constexpr int kChargingMask = 0x78;

int FlagsOf(const RobotSnapshot& snapshot) {
  return (snapshot.nav.home_saved ? 1 : 0) | (snapshot.mcu.obstacle ? 2 : 0) |
         (snapshot.mcu.infrared ? 4 : 0);
}

int MainsCode(long frequency_hz) {
  if (frequency_hz == 50) return 1;
  return frequency_hz == 60 ? 2 : 0;
}

std::string NavLines(const RobotSnapshot& snapshot) {
  const NavReading& nav = snapshot.nav;
  char text[512];
  std::snprintf(text, sizeof(text),
                "0|x=%d|y=%d|theta=%.3f|room=%d|ss=%d\n"
                "|beacon=%d|beacon_x=%d|next_room=%d|next_room_ss=%d\n"
                "|state=%d|ui_status=0|resistance=0|sm=%d|pp=0|flags=%04x\n",
                nav.x, nav.y, nav.theta_rad, nav.room, nav.signal_strength, nav.beacon,
                nav.beacon_x, nav.next_room, nav.next_room_signal_strength, nav.state,
                kIdleStateMachine, static_cast<unsigned>(FlagsOf(snapshot)));
  return text;
}

std::string DeviceLines(const RobotSnapshot& snapshot) {
  const RobotSettings& settings = snapshot.settings;
  char text[512];
  std::snprintf(text, sizeof(text),
                "|brightness=%ld|resolution=%ld|video_compression=%ld|frame_rate=%ld\n"
                "|privilege=%d|user_check=%d|speaker_volume=%ld|mic_volume=%ld\n"
                "|wifi_ss=%d|show_time=0|ddns_state=0|email_state=0\n"
                "|battery=%d|charging=%d|head_position=%d|ac_freq=%d",
                settings.brightness, settings.resolution, settings.compression_ratio,
                settings.frame_rate_hz, snapshot.caller_privilege == Privilege::kAdmin ? 0 : 1,
                snapshot.is_checking_users ? 1 : 0, settings.speaker_volume, settings.mic_volume,
                snapshot.wifi_signal_strength, snapshot.mcu.battery,
                McuStatusByte(snapshot.mcu) & kChargingMask, snapshot.mcu.head_position,
                MainsCode(settings.mains_frequency_hz));
  return text;
}

}  // namespace

std::string FormatNavReport(const RobotSnapshot& snapshot) {
  return NavLines(snapshot) + DeviceLines(snapshot);
}

}  // namespace rovio_sfm::sim
