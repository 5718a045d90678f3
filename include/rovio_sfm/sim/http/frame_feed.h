#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

// One encoded picture, shared by all who send it.
struct Picture {
  uint64_t number = 0;  // the count of captures begun when this one began, from 1
  std::shared_ptr<const std::vector<uint8_t>> jpeg;
};

// Hands the pictures of one capturing thread to any number of waiting connections; keeps the latest
// one only (a slow client misses pictures). Thread-safe.
class FrameFeed {
 public:
  // For the capturing thread. WaitForDemand blocks until somebody waits for a picture; false once
  // the feed is closed. (The robot encodes for 1 s more; no client can tell.)
  bool WaitForDemand();
  uint64_t BeginCapture();
  void Publish(uint64_t number, std::vector<uint8_t> jpeg);

  // Blocks for a picture newer than `number`; nothing after the time-out or once closed.
  std::optional<Picture> WaitForNewer(uint64_t number, std::chrono::milliseconds timeout);

  // A picture newer than this was begun after the call.
  uint64_t LastBegun();
  std::optional<Picture> Latest();
  bool IsClosed();

  // Ends every wait for good.
  void Close();

 private:
  bool HasNewer(uint64_t number) const REQUIRES(mutex_);

  Mutex mutex_;
  std::condition_variable_any changed_;
  uint64_t last_begun_ GUARDED_BY(mutex_) = 0;
  std::optional<Picture> latest_ GUARDED_BY(mutex_);
  int num_waiting_ GUARDED_BY(mutex_) = 0;
  bool closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm::sim
