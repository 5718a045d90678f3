#pragma once

#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// What the robot keeps in flash and reports back. The reported values are those last stored, even
// where the camera refused them (an invalid ResType is stored and not applied); `applied` is what
// the camera does.
struct RobotSettings {
  long resolution = 2;
  long compression_ratio = 1;
  long frame_rate_hz = 30;
  long brightness = 6;
  long speaker_volume = 15;
  long mic_volume = 15;
  long mains_frequency_hz = 50;  // 0 unknown, 50, 60
  CameraSettings applied;

  // Each stores the value and applies it as far as the camera takes it.
  void SetResolution(long value);
  void SetCompressionRatio(long value);
  void SetFrameRate(long value);
  void SetBrightness(long value);
};

}  // namespace rovio_sfm::sim
