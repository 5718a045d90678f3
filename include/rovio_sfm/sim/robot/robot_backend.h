#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"

namespace rovio_sfm::sim {

// The code that begins `responses` of a nav reply; the values are those of the wire.
enum class NavResponse : int {
  kSuccess = 0,
  kFailure = 1,
  kBusy = 2,
  kNotImplemented = 3,
  kUnknownAction = 4,
  kNoNorthStar = 5,
  kBaseNotSet = 8,
  kPathNotFound = 9,
  kPathNameMissing = 10,
  kNotRecording = 11,
  kOutOfRange = 22,
  kParameterMissing = 23,
};

// One manual drive command (nav action 18, drives 1-10, 17 and 18; the server maps head moves and
// stops to their own calls). Motors stop hold_ns after the command, except that 17 and 18 turn by
// their steps (about 11.25 deg * N + 11.25 deg) and then stop; with hold_ns = kHoldForever even
// those never end (the "spins eternally" fault).
struct DriveCommand {
  int drive = 0;
  int speed = 1;                   // 1 fastest … 10 slowest
  std::optional<int> angle_steps;  // 17 and 18 only
  int64_t hold_ns = 0;
};
inline constexpr int64_t kHoldForever = INT64_MAX;

enum class HeadPosition { kDown, kMiddle, kUp };

// Ticks since the last ReadMcu are unsigned and sum over reversals; the direction byte holds the
// last sense only: 0x02 backward, 0x05 forward, 0x00 no motion since the last read.
struct WheelReading {
  uint8_t direction = 0;
  uint16_t ticks = 0;
};

struct McuReading {
  WheelReading left, right, rear;
  uint8_t head_position = 203;  // about 204 down, 135 middle, 65 up, and between while it moves
  uint8_t battery = 126;        // 106 … 127 normal
  bool headlight = false;
  bool infrared = false;  // the obstacle detector is on
  bool obstacle = false;
  bool charge_complete = false;
  bool charging = false;
  bool charger_error = false;
  bool on_dock = false;
};

// What GetReport says of NorthStar and of autonomous motion, in the robot's units.
struct NavReading {
  int x = 0;
  int y = 0;
  double theta_rad = 0.0;  // (-pi, pi]
  int room = 0;
  int signal_strength = 0;
  int beacon = 0;
  int beacon_x = 0;
  int next_room = -1;
  int next_room_signal_strength = 0;
  int state = 0;  // 0 idle, 1 driving home, 2 docking
  bool home_saved = false;
};

// For tests and evaluation; real robots do not tell. World: metres, z up. Base: x forward, y left.
struct TruePose {
  int64_t time_ns = 0;
  Rigid3 world_from_base;
  Rigid3 world_from_camera;  // camera: x right, y down, z forward
};

struct CameraSettings {
  int resolution = 2;         // ResType: 0 176x144, 1 320x240, 2 352x288, 3 640x480
  int compression_ratio = 1;  // 0 … 2: low, medium, high JPEG quality
  int frame_rate_hz = 30;     // 1 … 30
  int brightness = 6;         // 0 … 6
};

struct CapturedImage {
  int64_t time_ns = 0;
  std::vector<uint8_t> jpeg;
};

// Any robot behind the HTTP face: simulated, a folder of images, or a fake of a test.
//
// Time is the server's clock in ns and never runs back. The server calls AdvanceTo(now) before each
// call below; motion between two calls follows from the last command and its hold time, so that the
// same commands at the same times give the same robot. All methods but Capture are called under one
// lock of the server. Capture is called by one capture thread, once a frame period and only while
// somebody wants images, WITHOUT that lock (rendering is slow): guard what it shares with the rest.
class RobotBackend {
 public:
  virtual ~RobotBackend() = default;

  virtual void AdvanceTo(int64_t time_ns) = 0;

  // Called with validated values: drive 1-10, 17 or 18, speed 1-10, angle_steps 0-255.
  virtual NavResponse Drive(const DriveCommand& command) = 0;
  virtual void Stop() = 0;                         // wheels and head, at once
  virtual void MoveHead(HeadPosition target) = 0;  // takes about 1 s
  virtual void SwitchHeadlight(bool on) = 0;
  virtual void SwitchInfrared(bool on) = 0;

  virtual McuReading ReadMcu() = 0;        // clears ticks and direction bytes
  virtual McuReading PeekMcu() const = 0;  // clears nothing (battery, head, status)
  virtual NavReading ReadNav() const = 0;

  virtual NavResponse SaveHome() { return NavResponse::kNotImplemented; }
  virtual NavResponse ClearHome() { return NavResponse::kNotImplemented; }
  virtual NavResponse GoHome(bool dock) {
    (void)dock;
    return NavResponse::kNotImplemented;
  }
  virtual void AbortAutonomy() {}  // nav action 17

  virtual TruePose ReadTruth() const = 0;

  // The picture of time_ns >= the last AdvanceTo in these settings, or nothing when no picture
  // comes (any more).
  virtual std::optional<CapturedImage> Capture(int64_t time_ns, const CameraSettings& settings) = 0;
};

struct ImageSize {
  int width = 0;
  int height = 0;
};

// The size of a ResType; the firmware's, not the printed specification's. Needs 0 … 3.
inline ImageSize SizeOfResolution(int resolution) {
  constexpr ImageSize kSizes[] = {{176, 144}, {320, 240}, {352, 288}, {640, 480}};
  return kSizes[resolution];
}

}  // namespace rovio_sfm::sim
