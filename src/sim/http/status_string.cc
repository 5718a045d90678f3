#include "rovio_sfm/sim/http/status_string.h"

#include <algorithm>
#include <cstdio>

namespace rovio_sfm::sim {
namespace {

// A stored setting as the firmware's unsigned field shows it, kept within its digits.
unsigned Field(long value, unsigned max) {
  return static_cast<unsigned>(std::clamp(value, 0L, static_cast<long>(max)));
}

}  // namespace

std::string FormatStatus(const RobotSnapshot& snapshot) {
  const RobotSettings& settings = snapshot.settings;
  char head[128], tail[128];
  std::snprintf(head, sizeof(head), "010000000000000%03u000%1u%1u%1u%06u0%1u%08u",
                Field(settings.brightness, 999), Field(settings.resolution, 9),
                Field(settings.compression_ratio, 9),
                snapshot.caller_privilege == Privilege::kAdmin ? 0u : 1u, snapshot.picture_index,
                snapshot.is_checking_users ? 1u : 0u, snapshot.picture_bytes);
  // Motion rectangle, ftp, saturation, motion index, hue, sharpness, miscellaneous: never in use.
  const std::string unused =
      "0000000000000000"
      "0"
      "000"
      "999999"
      "000"
      "000"
      "0000000000";
  std::snprintf(tail, sizeof(tail), "%03u%03u%03u0%02x%02x", Field(settings.frame_rate_hz, 999),
                Field(settings.speaker_volume, 999), Field(settings.mic_volume, 999),
                Field(snapshot.wifi_signal_strength, 255), snapshot.mcu.battery);
  return head + unused + tail;
}

}  // namespace rovio_sfm::sim
