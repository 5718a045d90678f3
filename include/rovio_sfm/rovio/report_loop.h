#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/back_off.h"
#include "rovio_sfm/rovio/rovio_client.h"
#include "rovio_sfm/rovio/settings_keeper.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

struct ReportLoopOptions {
  std::optional<CameraSettings> wanted_settings;  // asked for once, when the robot is there
  int max_failures = 3;                           // in a row; then the link counts as down
  BackOffOptions back_off;

  bool IsValid(std::string* error) const;
};

// Asks the robot how its wheels turned and how it is, on a worker of its own. Timers say when;
// questions that come while the robot is slow or away are dropped, with back-off after failures.
// Borrows the transport, which only this object may use. To end it, cancel that and destroy this.
class ReportLoop {
 public:
  // All are called on the worker.
  struct Callbacks {
    std::function<void(const McuReport&, int64_t stamp_ns)> on_mcu;
    std::function<void()> on_lost_mcu;  // asked, not answered: its ticks may be gone
    std::function<void(const RobotReport&)> on_report;
    std::function<void(bool is_up, const std::string& reason)> on_link;  // when it changes
    std::function<void(bool has_obeyed, const std::string& settings)> on_settings;  // once
    std::function<int64_t()> now_ns;
  };

  ReportLoop(const ReportLoopOptions& options, HttpTransport* transport, Callbacks callbacks);

  void PollMcu() { worker_.Push(Question::kMcu); }
  void PollReport() { worker_.Push(Question::kReport); }

  // Handles what is asked already, then ends the worker.
  void Finish() { worker_.Finish(); }

  uint64_t NumFailures() const { return num_failures_; }

 private:
  enum class Question { kMcu, kReport };

  void Ask(Question question);
  RobotOutcome AskMcu();
  RobotOutcome AskReport();
  void KeepSettings(const CameraSettings& present);
  void NoteSuccess();
  void NoteFailure(const RobotOutcome& outcome);

  const ReportLoopOptions options_;
  const Callbacks callbacks_;
  RovioClient client_;
  SettingsKeeper settings_;
  BackOff back_off_;
  std::optional<bool> is_up_;
  int num_failures_in_row_ = 0;
  int64_t next_attempt_ns_ = INT64_MIN;
  std::atomic<uint64_t> num_failures_{0};
  // Two questions wait at most; older ones are dropped.
  Worker<Question> worker_;
};

}  // namespace rovio_sfm
