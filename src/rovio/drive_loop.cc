#include "rovio_sfm/rovio/drive_loop.h"

#include <optional>
#include <utility>

namespace rovio_sfm {

DriveLoop::DriveLoop(const DriveOptions& options, HttpTransport* transport, OnOutcome on_outcome)
    : scheduler_(options),
      client_(transport),
      on_outcome_(std::move(on_outcome)),
      worker_(1, WhenFull::kDropOldest, [this](int64_t now_ns) { Send(now_ns); }) {}

void DriveLoop::SetWish(const BaseVelocity& velocity, int64_t now_ns) {
  {
    MutexLock lock(mutex_);
    scheduler_.NoteAwake(now_ns);
    scheduler_.SetWish(velocity, now_ns);
  }
  worker_.Push(now_ns);
}

void DriveLoop::Tick(int64_t now_ns) {
  {
    MutexLock lock(mutex_);
    scheduler_.NoteAwake(now_ns);
  }
  worker_.Push(now_ns);
}

bool DriveLoop::IsMoving() const {
  MutexLock lock(mutex_);
  return scheduler_.IsMoving();
}

void DriveLoop::Send(int64_t now_ns) {
  std::optional<DriveCommand> command;
  {
    MutexLock lock(mutex_);
    command = scheduler_.Next(now_ns);
  }
  if (!command) return;
  const RobotOutcome outcome = client_.Drive(*command);
  {
    MutexLock lock(mutex_);
    scheduler_.MarkSent(*command, outcome.IsOk());
  }
  on_outcome_(*command, outcome);
}

void DriveLoop::Shutdown() {
  worker_.Stop();
  if (!IsMoving()) return;
  const RobotOutcome outcome = client_.Drive({});
  MutexLock lock(mutex_);
  scheduler_.SetWish({}, 0);
  scheduler_.MarkSent({}, true);  // nothing more can be done: its last command expires
  (void)outcome;
}

}  // namespace rovio_sfm
