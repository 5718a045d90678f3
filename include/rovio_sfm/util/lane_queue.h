#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// What a full lane does with the next item: forget its own oldest, or not take it in.
enum class LaneFull { kDropOldest, kRefuse };

// A lane is full with so many items, or with so many bytes (an item larger than that fits alone).
struct LaneOptions {
  size_t max_items = 1;
  LaneFull when_full = LaneFull::kRefuse;
  size_t max_bytes = std::numeric_limits<size_t>::max();
};

// A first-in first-out queue of several kinds of items, each kind in a lane with its own bounds, so
// that a flood of one pushes out no other. Items of all lanes come out in the order they came in.
// Thread-safe. After Close() nothing is taken in any more; what is inside can still be popped.
template <typename T>
class LaneQueue {
 public:
  explicit LaneQueue(const std::vector<LaneOptions>& lanes) {
    for (const LaneOptions& options : lanes) {
      ROVIO_CHECK(options.max_items > 0, "a lane needs room for one item");
      lanes_.push_back({options, {}, 0, 0});
    }
  }

  // False when the lane refuses, which counts as dropped, or when the queue is closed.
  bool Push(size_t lane_index, T item, size_t num_bytes = 0) EXCLUDES(mutex_) {
    {
      MutexLock lock(mutex_);
      Lane& lane = lanes_.at(lane_index);
      if (is_closed_) return false;
      while (IsFull(lane, num_bytes)) {
        ++lane.num_dropped;
        if (lane.options.when_full == LaneFull::kRefuse) return false;
        TakeFront(&lane);
      }
      lane.num_bytes += num_bytes;
      lane.entries.push_back({next_number_++, num_bytes, std::move(item)});
    }
    has_item_.notify_one();
    return true;
  }

  // Waits for an item; nothing when the queue is closed and empty.
  std::optional<T> Pop() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    Lane* oldest = FindOldest();
    while (oldest == nullptr && !is_closed_) {
      has_item_.wait(mutex_);
      oldest = FindOldest();
    }
    if (oldest == nullptr) return std::nullopt;
    return TakeFront(oldest);
  }

  // Takes in nothing more and wakes all who wait.
  void Close() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    is_closed_ = true;
    has_item_.notify_all();
  }

  // Forgets the items inside, counted as dropped; returns how many.
  size_t Clear() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    size_t count = 0;
    for (Lane& lane : lanes_) {
      count += lane.entries.size();
      lane.num_dropped += lane.entries.size();
      lane.entries.clear();
      lane.num_bytes = 0;
    }
    return count;
  }

  size_t Size() const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    size_t count = 0;
    for (const Lane& lane : lanes_) count += lane.entries.size();
    return count;
  }

  size_t Size(size_t lane) const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return lanes_.at(lane).entries.size();
  }

  uint64_t NumDropped(size_t lane) const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return lanes_.at(lane).num_dropped;
  }

 private:
  struct Entry {
    uint64_t number = 0;  // of all lanes, by arrival
    size_t num_bytes = 0;
    T item;
  };
  struct Lane {
    LaneOptions options;
    std::deque<Entry> entries;
    size_t num_bytes = 0;
    uint64_t num_dropped = 0;
  };

  static bool IsFull(const Lane& lane, size_t num_more_bytes) {
    if (lane.entries.empty()) return false;
    return lane.entries.size() >= lane.options.max_items ||
           lane.num_bytes + num_more_bytes > lane.options.max_bytes;
  }

  Lane* FindOldest() REQUIRES(mutex_) {
    Lane* oldest = nullptr;
    for (Lane& lane : lanes_) {
      if (lane.entries.empty()) continue;
      const bool is_older =
          oldest == nullptr || lane.entries.front().number < oldest->entries.front().number;
      if (is_older) oldest = &lane;
    }
    return oldest;
  }

  T TakeFront(Lane* lane) REQUIRES(mutex_) {
    T item = std::move(lane->entries.front().item);
    lane->num_bytes -= lane->entries.front().num_bytes;
    lane->entries.pop_front();
    return item;
  }

  mutable Mutex mutex_;
  std::condition_variable_any has_item_;
  std::vector<Lane> lanes_ GUARDED_BY(mutex_);
  uint64_t next_number_ GUARDED_BY(mutex_) = 0;
  bool is_closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm
