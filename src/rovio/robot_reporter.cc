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
  if (callbacks_.now_ns() < next_attempt_ns_) return;
  const RobotOutcome outcome = (this->*fetch)();
  if (outcome.IsOk()) {
    NoteSuccess();
  } else {
    NoteFailure(outcome);
  }
}

// The ticks are those of about the middle of the call.
RobotOutcome RobotReporter::FetchMcu() {
  const int64_t asked_ns = callbacks_.now_ns();
  const RobotReply<McuReport> reply = client_.GetMcuReport();
  if (reply.value) {
    callbacks_.on_mcu(*reply.value, asked_ns + (callbacks_.now_ns() - asked_ns) / 2);
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

void RobotReporter::KeepSettings(const CameraSettings& present) {
  const SettingsKeeper::Step step = settings_.Next(present, callbacks_.now_ns());
  if (step == SettingsKeeper::Step::kRequest) {
    const RobotOutcome outcome = client_.RequestSettings(settings_.Wanted(), present);
    settings_.MarkRequested(outcome.IsOk(), callbacks_.now_ns());
  } else if (step != SettingsKeeper::Step::kNothing) {
    callbacks_.on_settings(step == SettingsKeeper::Step::kAgreed, Describe(present));
  }
}

void RobotReporter::NoteSuccess() {
  num_failures_in_row_ = 0;
  back_off_.Reset();
  if (is_up_ == true) return;
  is_up_ = true;
  callbacks_.on_link(true, "the robot answers");
}

void RobotReporter::NoteFailure(const RobotOutcome& outcome) {
  ++num_failures_;
  next_attempt_ns_ = callbacks_.now_ns() + static_cast<int64_t>(back_off_.NextDelaySeconds() * 1e9);
  if (++num_failures_in_row_ < options_.max_failures || is_up_ == false) return;
  is_up_ = false;
  callbacks_.on_link(false, outcome.message);
}

}  // namespace rovio_sfm
