#include "rovio_sfm/app/odometry_buffer.h"

#include <algorithm>

#include "rovio_sfm/scene/stamp_order.h"

namespace rovio_sfm {

void OdometryBuffer::Add(const StampedOdometry& sample) {
  if (!samples_.empty()) {
    const StampOrder order = OrderOf(sample.stamp_ns, samples_.back().stamp_ns);
    if (order == StampOrder::kLate) return;
    if (order == StampOrder::kJumpedBack) samples_.clear();
  }
  samples_.push_back(sample);
  ForgetOld();
}

std::optional<OdometrySample> OdometryBuffer::At(int64_t stamp_ns) const {
  return InterpolateOdometry(samples_, stamp_ns, max_gap_ns_);
}

// Erases in one go once half of what is held is too old, so that a sample costs constant time.
void OdometryBuffer::ForgetOld() {
  const int64_t oldest_ns = samples_.back().stamp_ns - memory_ns_;
  if (samples_[samples_.size() / 2].stamp_ns >= oldest_ns) return;
  const auto first_kept = std::find_if(samples_.begin(), samples_.end(), [&](const auto& sample) {
    return sample.stamp_ns >= oldest_ns;
  });
  samples_.erase(samples_.begin(), first_kept);
}

}  // namespace rovio_sfm
