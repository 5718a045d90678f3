#pragma once

#include <chrono>
#include <condition_variable>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

// Tells many threads to end, once and for good; a wait that can be cut short. Thread-safe.
class StopSignal {
 public:
  void Request();
  bool IsRequested() const;

  // Returns true as soon as the stop is requested, false after the duration.
  bool WaitFor(std::chrono::nanoseconds duration) const;

 private:
  mutable Mutex mutex_;
  mutable std::condition_variable_any changed_;
  bool requested_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm::sim
