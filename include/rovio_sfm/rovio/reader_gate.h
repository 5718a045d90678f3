#pragma once

#include <chrono>
#include <condition_variable>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// Where the image reader waits: while nobody wants images, and between two attempts. Thread-safe.
class ReaderGate {
 public:
  explicit ReaderGate(bool is_open) : is_open_(is_open) {}

  void SetOpen(bool is_open) EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    is_open_ = is_open;
    changed_.notify_all();
  }

  // Ends all waiting, for good.
  void Stop() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    is_stopped_ = true;
    changed_.notify_all();
  }

  bool IsStopped() const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return is_stopped_;
  }

  // Waits until the gate is open; false when it was stopped.
  bool WaitUntilOpen() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    while (!is_open_ && !is_stopped_) changed_.wait(mutex_);
    return !is_stopped_;
  }

  // Waits this long, open or not; false when it was stopped.
  bool WaitFor(double seconds) EXCLUDES(mutex_) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    MutexLock lock(mutex_);
    while (!is_stopped_ && changed_.wait_until(mutex_, end) != std::cv_status::timeout) {
    }
    return !is_stopped_;
  }

 private:
  mutable Mutex mutex_;
  std::condition_variable_any changed_;
  bool is_open_ GUARDED_BY(mutex_);
  bool is_stopped_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm
