#include "rovio_sfm/rovio/robot_reporter.h"

#include <utility>

namespace rovio_sfm {

RobotReporter::RobotReporter(const ReporterOptions& options, HttpTransport* transport,
                             Callbacks callbacks)
    : options_(options),
      callbacks_(std::move(callbacks)),
      client_(transport),
      settings_(options.wanted_settings),
      back_off_(options.back_off) {}

void RobotReporter::Ask(RobotOutcome (RobotReporter::*fetch)()) {
  const int64_t asked_ns = callbacks_.steady_ns();
  if (asked_ns < next_attempt_ns_) return;
  if (!silent_since_ns_) silent_since_ns_ = asked_ns;
  const RobotOutcome outcome = (this->*fetch)();
  if (outcome.IsOk()) {
    NoteSuccess();
  } else {
    NoteFailure(outcome);
  }
}

// The ticks are those of about the middle of the call.
RobotOutcome RobotReporter::FetchMcu() {
  const int64_t asked_ns = callbacks_.steady_ns();
  const RobotReply<McuReport> reply = client_.GetMcuReport();
  if (reply.value) {
    const int64_t answered_ns = callbacks_.steady_ns();
    const int64_t age_ns = (answered_ns - asked_ns) / 2;
    callbacks_.on_mcu(*reply.value, {callbacks_.now_ns() - age_ns, answered_ns - age_ns});
  } else {
    callbacks_.on_lost_mcu();
  }
  return reply.outcome;
}

RobotOutcome RobotReporter::FetchReport() {
  const RobotReply<RobotReport> reply = client_.GetReport();
  if (!reply.value) return reply.outcome;
  callbacks_.on_report(*reply.value);
  KeepSettings(reply.value->camera);
  return reply.outcome;
}

void RobotReporter::KeepSettings(const SomeSettings& present) {
  const SettingsKeeper::Step step = settings_.Next(present, callbacks_.steady_ns());
  if (step == SettingsKeeper::Step::kRequest) {
    const RobotOutcome outcome = client_.RequestSettings(settings_.Wanted(), present);
    settings_.MarkRequested(outcome.IsOk(), callbacks_.steady_ns());
  } else if (step != SettingsKeeper::Step::kNothing) {
    callbacks_.on_settings(step == SettingsKeeper::Step::kAgreed, present);
  }
}

void RobotReporter::NoteSuccess() {
  num_failures_in_row_ = 0;
  silent_since_ns_.reset();
  back_off_.Reset();
  if (is_up_ == true) return;
  is_up_ = true;
  callbacks_.on_link(true, "the robot answers");
}

void RobotReporter::NoteFailure(const RobotOutcome& outcome) {
  ++num_failures_;
  const int64_t now_ns = callbacks_.steady_ns();
  next_attempt_ns_ = now_ns + static_cast<int64_t>(back_off_.NextDelaySeconds() * 1e9);
  const bool is_silent = now_ns - *silent_since_ns_ >= options_.max_silence_ns;
  if ((++num_failures_in_row_ < options_.max_failures && !is_silent) || is_up_ == false) return;
  is_up_ = false;
  settings_.BeginAgain();
  callbacks_.on_link(false, outcome.message);
}

}  // namespace rovio_sfm
