#include "rovio_sfm/sim/http/stop_signal.h"

namespace rovio_sfm::sim {

void StopSignal::Request() {
  const MutexLock lock(mutex_);
  requested_ = true;
  changed_.notify_all();
}

bool StopSignal::IsRequested() const {
  const MutexLock lock(mutex_);
  return requested_;
}

bool StopSignal::WaitFor(std::chrono::nanoseconds duration) const {
  const auto end = std::chrono::steady_clock::now() + duration;
  const MutexLock lock(mutex_);
  while (!requested_) {
    if (changed_.wait_until(mutex_, end) == std::cv_status::timeout) break;
  }
  return requested_;
}

}  // namespace rovio_sfm::sim
