#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/rovio_protocol.h"

namespace rovio_sfm {

// Brings the camera to the wished settings once, and finds out whether the robot obeyed: it answers
// before it acts and hides refusals, and every change wears out its flash. So: one request, then
// reports are compared until they agree or the patience ends. What the robot does not report is
// asked for, and taken as granted. A robot that was away may have forgotten: what it had last is
// wished for again. Times in ns. Not thread-safe.
class SettingsKeeper {
 public:
  enum class Step { kNothing, kRequest, kAgreed, kRefused };

  explicit SettingsKeeper(const std::optional<CameraSettings>& wanted);

  // What to do now that the robot reports these settings. kAgreed and kRefused come once.
  Step Next(const SomeSettings& present, int64_t now_ns);

  // After kRequest; has_arrived is false when it could not be sent: the next report asks again.
  void MarkRequested(bool has_arrived, int64_t now_ns);

  // The robot is away: the next report is looked at as the first one was.
  void BeginAgain();

  // Neither agreed nor refused yet: what changes is our own doing.
  bool IsSettling() const { return wanted_ && !is_done_; }
  const SomeSettings& Wanted() const { return *wanted_; }

 private:
  std::optional<SomeSettings> wanted_;
  std::optional<int64_t> requested_ns_;
  bool was_requested_ = false;  // ever: what is not reported is granted
  bool is_done_ = false, is_agreed_ = false;
};

// "resolution 3, compression 2, …"; "?" for what is not known.
std::string Describe(const SomeSettings& settings);

// True if no setting is known of both and differs.
bool AreAgreed(const SomeSettings& a, const SomeSettings& b);

}  // namespace rovio_sfm
