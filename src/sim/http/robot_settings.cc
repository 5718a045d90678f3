#include "rovio_sfm/sim/http/robot_settings.h"

#include <algorithm>

namespace rovio_sfm::sim {

void RobotSettings::SetResolution(long value) {
  resolution = value;
  if (value >= 0 && value <= 3) applied.resolution = static_cast<int>(value);
}

// Unlike the others, a ratio out of range is not even stored.
void RobotSettings::SetCompressionRatio(long value) {
  if (value < 0 || value > 2) return;
  compression_ratio = value;
  applied.compression_ratio = static_cast<int>(value);
}

void RobotSettings::SetFrameRate(long value) {
  frame_rate_hz = value;
  if (value >= 1 && value < 100) applied.frame_rate_hz = static_cast<int>(std::min(value, 30L));
}

void RobotSettings::SetBrightness(long value) {
  brightness = value;
  if (value >= 0 && value <= 6) applied.brightness = static_cast<int>(value);
}

}  // namespace rovio_sfm::sim
