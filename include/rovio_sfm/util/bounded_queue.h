#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// What Push does when the queue is full: forget the oldest item, or wait for room.
enum class WhenFull { kDropOldest, kBlock };

// A first-in first-out queue of bounded length. Thread-safe. After Close() nothing is taken in any
// more; what is inside can still be popped.
template <typename T>
class BoundedQueue {
 public:
  BoundedQueue(size_t capacity, WhenFull when_full) : capacity_(capacity), when_full_(when_full) {
    ROVIO_CHECK(capacity > 0, "a queue needs room for one item");
  }

  // False when the queue is closed; the item is then not kept.
  bool Push(T item) EXCLUDES(mutex_) {
    {
      MutexLock lock(mutex_);
      while (IsFullAndMustWait()) has_room_.wait(mutex_);
      if (is_closed_) return false;
      if (items_.size() == capacity_) {
        items_.pop_front();
        ++num_dropped_;
      }
      items_.push_back(std::move(item));
    }
    has_item_.notify_one();
    return true;
  }

  // Waits for an item; nothing when the queue is closed and empty.
  std::optional<T> Pop() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    while (items_.empty() && !is_closed_) has_item_.wait(mutex_);
    return TakeFront();
  }

  // The oldest item, or nothing; never waits.
  std::optional<T> TryPop() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return TakeFront();
  }

  // Takes in nothing more and wakes all who wait.
  void Close() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    is_closed_ = true;
    has_item_.notify_all();
    has_room_.notify_all();
  }

  // Forgets the items inside, counted as dropped; returns how many.
  size_t Clear() EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    const size_t count = items_.size();
    num_dropped_ += count;
    items_.clear();
    has_room_.notify_all();
    return count;
  }

  size_t Size() const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return items_.size();
  }

  uint64_t NumDropped() const EXCLUDES(mutex_) {
    MutexLock lock(mutex_);
    return num_dropped_;
  }

 private:
  bool IsFullAndMustWait() const REQUIRES(mutex_) {
    return when_full_ == WhenFull::kBlock && items_.size() == capacity_ && !is_closed_;
  }

  std::optional<T> TakeFront() REQUIRES(mutex_) {
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    has_room_.notify_one();
    return item;
  }

  const size_t capacity_;
  const WhenFull when_full_;
  mutable Mutex mutex_;
  std::condition_variable_any has_item_;
  std::condition_variable_any has_room_;
  std::deque<T> items_ GUARDED_BY(mutex_);
  uint64_t num_dropped_ GUARDED_BY(mutex_) = 0;
  bool is_closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm
