#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/back_off.h"
#include "rovio_sfm/rovio/rovio_client.h"
#include "rovio_sfm/rovio/settings_keeper.h"

namespace rovio_sfm {

struct ReporterOptions {
  std::optional<CameraSettings> wanted_settings;  // asked for once each time the robot comes
  int max_failures = 3;                           // in a row; then the link counts as down,
  int64_t max_silence_ns = 2'000'000'000;         // as after so long without an answer
  BackOffOptions back_off;
};

// When a reading was taken: by the clock that stamps bear, which may jump, and by the steady one.
struct ReadingTime {
  int64_t stamp_ns = 0;
  int64_t steady_ns = 0;
};

// Asks the robot how its wheels turned and how it is, and tells when the link comes and goes. After
// a failure questions are left out until the back-off has passed. Use from one thread; borrows the
// transport, which only this object may use.
class RobotReporter {
 public:
  // All are called by AskMcu and AskReport.
  struct Callbacks {
    std::function<void(const McuReport&, const ReadingTime&)> on_mcu;
    std::function<void()> on_lost_mcu;  // asked, not answered: its ticks may be gone
    std::function<void(const RobotReport&)> on_report;
    std::function<void(bool is_up, const std::string& reason)> on_link;  // when it changes
    // Once each time the robot comes.
    std::function<void(bool has_obeyed, const SomeSettings& settings)> on_settings;
    std::function<int64_t()> now_ns;     // of stamps
    std::function<int64_t()> steady_ns;  // of everything else
  };

  RobotReporter(const ReporterOptions& options, HttpTransport* transport, Callbacks callbacks);

  void AskMcu() { Ask(&RobotReporter::FetchMcu); }
  void AskReport() { Ask(&RobotReporter::FetchReport); }

  bool IsSettling() const { return settings_.IsSettling(); }
  uint64_t NumFailures() const { return num_failures_; }

 private:
  void Ask(RobotOutcome (RobotReporter::*fetch)());
  RobotOutcome FetchMcu();
  RobotOutcome FetchReport();
  void KeepSettings(const SomeSettings& present);
  void NoteSuccess();
  void NoteFailure(const RobotOutcome& outcome);

  const ReporterOptions options_;
  const Callbacks callbacks_;
  RovioClient client_;
  SettingsKeeper settings_;
  BackOff back_off_;
  std::optional<bool> is_up_;
  int num_failures_in_row_ = 0;
  int64_t next_attempt_ns_ = INT64_MIN;     // steady, as the next
  std::optional<int64_t> silent_since_ns_;  // when the first question in vain was asked
  std::atomic<uint64_t> num_failures_{0};
};

}  // namespace rovio_sfm
