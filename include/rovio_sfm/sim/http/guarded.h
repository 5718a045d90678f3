#pragma once

#include <utility>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

// A value that threads reach only under its own lock: guarded.With([](Value& value) {...}). The
// function must not call With of the same object, nor block.
template <typename Value>
class Guarded {
 public:
  template <typename... Arguments>
  explicit Guarded(Arguments&&... arguments) : value_{std::forward<Arguments>(arguments)...} {}

  template <typename Function>
  auto With(Function&& function) {
    const MutexLock lock(mutex_);
    return function(value_);
  }

  Value Copy() {
    const MutexLock lock(mutex_);
    return value_;
  }

 private:
  Mutex mutex_;
  Value value_ GUARDED_BY(mutex_);
};

}  // namespace rovio_sfm::sim
