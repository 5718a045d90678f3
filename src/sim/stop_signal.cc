#include "rovio_sfm/sim/stop_signal.h"

namespace rovio_sfm::sim {

void StopSignal::Request() {
  const std::lock_guard<std::mutex> lock(mutex_);
  requested_ = true;
  changed_.notify_all();
}

bool StopSignal::IsRequested() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return requested_;
}

bool StopSignal::WaitFor(std::chrono::nanoseconds duration) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, duration, [this] { return requested_; });
}

}  // namespace rovio_sfm::sim
