#include "rovio_sfm/sim/http/frame_feed.h"

#include <utility>

namespace rovio_sfm::sim {

bool FrameFeed::HasNewer(uint64_t number) const { return latest_ && latest_->number > number; }

bool FrameFeed::WaitForDemand() {
  const MutexLock lock(mutex_);
  while (!closed_ && num_waiting_ == 0) changed_.wait(mutex_);
  return !closed_;
}

uint64_t FrameFeed::BeginCapture() {
  const MutexLock lock(mutex_);
  return ++last_begun_;
}

void FrameFeed::Publish(uint64_t number, std::vector<uint8_t> jpeg) {
  auto shared = std::make_shared<const std::vector<uint8_t>>(std::move(jpeg));
  const MutexLock lock(mutex_);
  latest_ = Picture{number, std::move(shared)};
  changed_.notify_all();
}

std::optional<Picture> FrameFeed::WaitForNewer(uint64_t number, std::chrono::milliseconds timeout) {
  const auto end = std::chrono::steady_clock::now() + timeout;
  const MutexLock lock(mutex_);
  ++num_waiting_;
  changed_.notify_all();
  while (!closed_ && !HasNewer(number)) {
    if (changed_.wait_until(mutex_, end) == std::cv_status::timeout) break;
  }
  --num_waiting_;
  if (closed_ || !HasNewer(number)) return std::nullopt;
  return latest_;
}

uint64_t FrameFeed::LastBegun() {
  const MutexLock lock(mutex_);
  return last_begun_;
}

std::optional<Picture> FrameFeed::Latest() {
  const MutexLock lock(mutex_);
  return latest_;
}

bool FrameFeed::IsClosed() {
  const MutexLock lock(mutex_);
  return closed_;
}

void FrameFeed::Close() {
  const MutexLock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

}  // namespace rovio_sfm::sim
