#include "rovio_sfm/sim/frame_feed.h"

#include <utility>

namespace rovio_sfm::sim {

bool FrameFeed::WaitForDemand() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return closed_ || num_waiting_ > 0; });
  return !closed_;
}

uint64_t FrameFeed::BeginCapture() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ++last_begun_;
}

void FrameFeed::Publish(uint64_t number, std::vector<uint8_t> jpeg) {
  auto shared = std::make_shared<const std::vector<uint8_t>>(std::move(jpeg));
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_ = Picture{number, std::move(shared)};
  changed_.notify_all();
}

std::optional<Picture> FrameFeed::WaitForNewer(uint64_t number, std::chrono::milliseconds timeout) {
  std::unique_lock<std::mutex> lock(mutex_);
  ++num_waiting_;
  changed_.notify_all();
  changed_.wait_for(lock, timeout,
                    [&] { return closed_ || (latest_ && latest_->number > number); });
  --num_waiting_;
  if (closed_ || !latest_ || latest_->number <= number) return std::nullopt;
  return latest_;
}

uint64_t FrameFeed::LastBegun() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_begun_;
}

std::optional<Picture> FrameFeed::Latest() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_;
}

bool FrameFeed::IsClosed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return closed_;
}

void FrameFeed::Close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

}  // namespace rovio_sfm::sim
