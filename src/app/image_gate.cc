#include "rovio_sfm/app/image_gate.h"

#include <utility>

namespace rovio_sfm {

void ImageGate::Add(RawImage image, double now_s) {
  if (!first_s_) first_s_ = now_s;
  while (waiting_.size() == kCapacity || NumBytes() > kMaxBytes) {
    waiting_.pop_front();
    ++num_dropped_;
  }
  waiting_.push_back({std::move(image), now_s});
}

size_t ImageGate::NumBytes() const {
  size_t sum = 0;
  for (const Entry& entry : waiting_) sum += entry.image.bytes ? entry.image.bytes->size() : 0;
  return sum;
}

std::optional<ImageEvent> ImageGate::Take(double now_s) {
  if (waiting_.empty() || !robot_->HasCamera() || !IsReady(waiting_.front(), now_s)) {
    return std::nullopt;
  }
  RawImage image = std::move(waiting_.front().image);
  waiting_.pop_front();
  return robot_->MakeEvent(image);
}

bool ImageGate::IsReady(const Entry& entry, double now_s) const {
  const bool is_starting = now_s - *first_s_ < options_.startup_wait_s;
  if (!is_starting && now_s - entry.arrived_s >= options_.max_wait_s) return true;
  const bool expects_head =
      !robot_->KnowsHead(entry.image) && (robot_->HasHead(entry.image) || is_starting);
  const bool expects_odometry =
      !robot_->OdometryCovers(entry.image) && (robot_->HasOdometry() || is_starting);
  return !expects_head && !expects_odometry;
}

}  // namespace rovio_sfm
