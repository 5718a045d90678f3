#pragma once

#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "rovio_sfm/util/lane_queue.h"

namespace rovio_sfm {

// A queue of several lanes and the one thread that empties it: `handle` is called for one item
// after the other, in the order they came in, whatever their lane, and must not throw. The
// destructor finishes what is queued.
template <typename T>
class LaneWorker {
 public:
  LaneWorker(const std::vector<LaneOptions>& lanes, std::function<void(T)> handle)
      : queue_(lanes), handle_(std::move(handle)), thread_([this] { Run(); }) {}
  ~LaneWorker() { Finish(); }
  LaneWorker(const LaneWorker&) = delete;
  LaneWorker& operator=(const LaneWorker&) = delete;

  // False when the lane is full and refuses, and after Finish or Stop: it is then not handled.
  bool Push(size_t lane, T item, size_t num_bytes = 0) {
    return queue_.Push(lane, std::move(item), num_bytes);
  }

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
  size_t NumQueued(size_t lane) const { return queue_.Size(lane); }
  uint64_t NumDropped(size_t lane) const { return queue_.NumDropped(lane); }

 private:
  void Run() {
    while (std::optional<T> item = queue_.Pop()) handle_(std::move(*item));
  }

  LaneQueue<T> queue_;
  const std::function<void(T)> handle_;
  std::thread thread_;  // last: starts when the others exist
};

}  // namespace rovio_sfm
