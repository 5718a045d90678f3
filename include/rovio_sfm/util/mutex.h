#pragma once

#include <condition_variable>
#include <mutex>

#if defined(__clang__)
#define ROVIO_THREAD_ATTRIBUTE(x) __attribute__((x))
#else
#define ROVIO_THREAD_ATTRIBUTE(x)
#endif
#define GUARDED_BY(mutex) ROVIO_THREAD_ATTRIBUTE(guarded_by(mutex))
#define REQUIRES(mutex) ROVIO_THREAD_ATTRIBUTE(requires_capability(mutex))
#define EXCLUDES(mutex) ROVIO_THREAD_ATTRIBUTE(locks_excluded(mutex))

namespace rovio_sfm {

// A std::mutex that clang's -Wthread-safety can follow. lock() and unlock() are spelt as the
// standard wants them, so that a condition variable can use it; elsewhere use MutexLock.
class ROVIO_THREAD_ATTRIBUTE(capability("mutex")) Mutex {
 public:
  void lock() ROVIO_THREAD_ATTRIBUTE(acquire_capability()) { mutex_.lock(); }
  void unlock() ROVIO_THREAD_ATTRIBUTE(release_capability()) { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

// Holds a Mutex for its own life.
class ROVIO_THREAD_ATTRIBUTE(scoped_lockable) MutexLock {
 public:
  explicit MutexLock(Mutex& mutex) ROVIO_THREAD_ATTRIBUTE(acquire_capability(mutex))
      : mutex_(mutex) {
    mutex_.lock();
  }
  ~MutexLock() ROVIO_THREAD_ATTRIBUTE(release_capability()) { mutex_.unlock(); }
  MutexLock(const MutexLock&) = delete;
  MutexLock& operator=(const MutexLock&) = delete;

 private:
  Mutex& mutex_;
};

}  // namespace rovio_sfm
