#pragma once

#include <cstdint>
#include <functional>

#include "rovio_sfm/rovio/drive_command.h"
#include "rovio_sfm/rovio/rovio_client.h"
#include "rovio_sfm/util/mutex.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

// Drives the robot as long as somebody wishes it to move, on a worker of its own, so that nothing
// else can hold up a stop. A timer calls Tick often (every 25 ms); times in ns, never falling, of a
// clock that goes on while the machine is suspended.
// Thread-safe. Borrows the transport, which only this object may use. Shutdown stops the robot.
class DriveLoop {
 public:
  // on_outcome is called on the worker for each command that was sent.
  using OnOutcome = std::function<void(const DriveCommand&, const RobotOutcome&)>;

  DriveLoop(const DriveOptions& options, HttpTransport* transport, OnOutcome on_outcome);
  ~DriveLoop() { Shutdown(); }

  void SetWish(const BaseVelocity& velocity, int64_t now_ns) EXCLUDES(mutex_);
  void Tick(int64_t now_ns) EXCLUDES(mutex_);

  bool IsMoving() const EXCLUDES(mutex_);

  // Ends the worker and sends a last stop if the robot may still move. Further calls do nothing.
  void Shutdown() EXCLUDES(mutex_);

 private:
  void Send(int64_t now_ns) EXCLUDES(mutex_);

  mutable Mutex mutex_;
  DriveScheduler scheduler_ GUARDED_BY(mutex_);
  RovioClient client_;  // of the worker; of Shutdown when that has ended
  const OnOutcome on_outcome_;
  // One tick waits at most; older ones are dropped: only the present counts.
  Worker<int64_t> worker_;
};

}  // namespace rovio_sfm
