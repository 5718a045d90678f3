#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/rovio_protocol.h"

namespace rovio_sfm {

// Notices that somebody else uses the robot too: wheels that turn though this driver does not drive
// and the robot is idle, camera settings that nobody here asked for. Times in steady ns. Not
// thread-safe.
class ForeignHand {
 public:
  // This driver moves the robot, or sent it somewhere: its wheels may turn for a while.
  void NoteOwnMotion(int64_t now_ns) { own_motion_ns_ = now_ns; }
  // This driver asked for settings: what the next reports say is its own doing, until so long.
  void NoteOwnSettings(int64_t now_ns) { own_settings_ns_ = now_ns; }

  void Look(const McuReport& mcu, int64_t now_ns);
  void Look(const RobotReport& report, int64_t now_ns);

  // What was seen within the last minute, for people; empty: nothing.
  std::string Reason(int64_t now_ns) const;

 private:
  static constexpr int64_t kLongAgo = INT64_MIN / 4;

  void Tell(const std::string& reason, int64_t now_ns);

  int64_t own_motion_ns_ = kLongAgo, own_settings_ns_ = kLongAgo, seen_ns_ = kLongAgo;
  bool has_reading_ = false;  // the first holds what happened before
  std::optional<SomeSettings> settings_;
  std::string reason_;
};

}  // namespace rovio_sfm
