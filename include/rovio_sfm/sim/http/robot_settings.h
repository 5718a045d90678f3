#pragma once

#include <cstdint>
#include <map>

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
  // Of the image sensor, by address, as debug.cgi reads and writes them; without effect here.
  std::map<uint8_t, uint8_t> sensor_registers = {
      {0x13, 0xf4}, {0x14, 0x4a}, {0x55, 0x00}, {0x56, 0x40}};

  // Each stores the value and applies it as far as the camera takes it.
  void SetResolution(long value);
  void SetCompressionRatio(long value);
  void SetFrameRate(long value);
  void SetBrightness(long value);
};

}  // namespace rovio_sfm::sim
