#pragma once

#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include "rovio_sfm/util/bounded_queue.h"

namespace rovio_sfm {

// A bounded queue and the one thread that empties it: `handle` is called for one item after the
// other, in order, and must not throw. Push from any thread but the worker's own when it may block.
// The destructor finishes what is queued.
template <typename T>
class Worker {
 public:
  Worker(size_t capacity, WhenFull when_full, std::function<void(T)> handle)
      : queue_(capacity, when_full), handle_(std::move(handle)), thread_([this] { Run(); }) {}
  ~Worker() { Finish(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // False after Finish or Stop; the item is then not handled.
  bool Push(T item) { return queue_.Push(std::move(item)); }

  // Takes in nothing more, handles what is queued and ends the thread. Call from one thread only.
  void Finish() {
    queue_.Close();
    if (thread_.joinable()) thread_.join();
  }

  // As Finish, but what is queued is forgotten; returns how many items that were.
  size_t Stop() {
    queue_.Close();
    const size_t num_forgotten = queue_.Clear();
    Finish();
    return num_forgotten;
  }

  size_t NumQueued() const { return queue_.Size(); }
  uint64_t NumDropped() const { return queue_.NumDropped(); }

 private:
  void Run() {
    while (std::optional<T> item = queue_.Pop()) handle_(std::move(*item));
  }

  BoundedQueue<T> queue_;
  const std::function<void(T)> handle_;
  std::thread thread_;  // last: starts when the others exist
};

}  // namespace rovio_sfm
