#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// What a node refused last, and why, for its diagnostics. Thread-safe; times of a steady clock.
class NewestRefusal {
 public:
  void Note(const std::string& reason, double now_s) EXCLUDES(mutex_);
  // Empty: nothing was refused yet.
  std::string Reason() const EXCLUDES(mutex_);
  // The same while it is news, half a minute; then empty.
  std::string RecentReason(double now_s) const EXCLUDES(mutex_);
  uint64_t Count() const EXCLUDES(mutex_);

 private:
  mutable Mutex mutex_;
  std::string reason_ GUARDED_BY(mutex_);
  double noted_s_ GUARDED_BY(mutex_) = 0.0;
  uint64_t count_ GUARDED_BY(mutex_) = 0;
};

}  // namespace rovio_sfm
