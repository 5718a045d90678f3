#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rovio_sfm/rovio/drive_code.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The camera's settings as the robot numbers them.
struct CameraSettings {
  int resolution = 3;
  int compression = 2;
  int frame_rate = 15;
  int brightness = 6;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("resolution", resolution, 0, 3, "0 176x144, 1 320x240, 2 352x288, 3 640x480");
    table.AddNumber("compression", compression, 0, 2, "0 low, 1 medium, 2 high quality");
    table.AddNumber("frame_rate", frame_rate, 1, 30, "per second");
    table.AddNumber("brightness", brightness, 0, 6, "");
  }
};

// Settings of which some may not be known, or not be wished for.
struct SomeSettings {
  SomeSettings() = default;
  explicit SomeSettings(const CameraSettings& all)
      : resolution(all.resolution),
        compression(all.compression),
        frame_rate(all.frame_rate),
        brightness(all.brightness) {}

  std::optional<int> resolution, compression, frame_rate, brightness;
};

// What GetReport says, as far as a driver can use it. Each field stands for itself: one that is
// missing or odd is not known, and named in `odd_fields`.
struct RobotReport {
  std::optional<int> state;            // 0 idle, 1 driving home, 2 docking, 3 path, 4 recording
  std::optional<int> signal_strength;  // NorthStar, 0 … 65535
  std::optional<bool> home_saved;
  std::optional<bool> obstacle;
  std::optional<bool> infrared_on;
  std::optional<bool> is_login_required;
  std::optional<int> wifi_strength;  // 0 … 254
  std::optional<int> battery;        // 106 … 127 normal, below 100 it switches off
  std::optional<int> charging;       // 0 off the dock, 64 docked, 72 full, 80 charging
  std::optional<int> head_position;  // about 204 down, 135 middle, 65 up
  SomeSettings camera;
  std::string odd_fields;  // "battery is missing, …"; empty: all are known
};

// One wheel since the last reading, which clears it. The ticks of a reversal are summed unsigned.
struct WheelTicks {
  uint8_t direction = 0;  // 0x02 one sense, 0x05 the other, 0 no motion
  uint16_t ticks = 0;
};

// What GetMCUReport says; wheels in the order left, right, rear.
struct McuReport {
  std::array<WheelTicks, 3> wheels;
  int head_position = 0;
  int battery = 0;
  bool headlight_on = false;
  bool infrared_on = false;
  bool obstacle = false;
  bool is_charge_complete = false;
  bool is_charging = false;
  bool is_on_dock = false;
};

enum class HeadPosition : uint8_t { kDown, kMiddle, kUp };

// Paths with query strings.
std::string ReportTarget();
std::string McuReportTarget();
std::string DriveTarget(DriveCode code, int speed);
std::string HeadTarget(HeadPosition position);
std::string StopMotionTarget();  // action 33
std::string ResetStateTarget();  // action 17: ends autonomous motion
std::string DockTarget();        // action 13
std::string HeadlightTarget(bool on);
std::string InfraredTarget(bool on);
std::string StillTarget(uint32_t number);  // the number only defeats caches
std::string StreamTarget();
std::string ResolutionTarget(int resolution);
std::string CompressionTarget(int compression);
std::string FrameRateTarget(int frame_rate);
std::string BrightnessTarget(int brightness);

// The robot's word for a code that begins `responses`, in plain English.
const char* DescribeNavCode(int code);

// The code of a nav reply; nothing when the body is no nav reply.
std::optional<int> ParseNavCode(std::string_view body);

// The report; nothing, with the reason, when the body is no such reply or refuses.
std::optional<RobotReport> ParseReport(std::string_view body, std::string* error);
std::optional<McuReport> ParseMcuReport(std::string_view body, std::string* error);

}  // namespace rovio_sfm
