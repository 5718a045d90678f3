#pragma once

#include <mutex>
#include <utility>

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
    const std::lock_guard<std::mutex> lock(mutex_);
    return function(value_);
  }

  Value Copy() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return value_;
  }

 private:
  std::mutex mutex_;
  Value value_;  // guarded by mutex_
};

}  // namespace rovio_sfm::sim
