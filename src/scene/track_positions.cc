#include "rovio_sfm/scene/track_positions.h"

#include <limits>

namespace rovio_sfm {

void TrackPositions::Add(TrackId track, const Eigen::Vector3d& position) {
  const bool is_step = track > last_ && track - last_ <= std::numeric_limits<uint8_t>::max();
  if (!is_step) jumps_.push_back(track);
  steps_.push_back(is_step ? static_cast<uint8_t>(track - last_) : kJump);
  positions_.push_back(position);
  last_ = track;
}

std::vector<std::pair<TrackId, Eigen::Vector3d>> TrackPositions::List() const {
  std::vector<std::pair<TrackId, Eigen::Vector3d>> list;
  TrackId track = 0;
  auto jump = jumps_.begin();
  for (size_t i = 0; i < steps_.size(); ++i) {
    track = steps_[i] == kJump ? *jump++ : track + steps_[i];
    list.emplace_back(track, positions_[i]);
  }
  return list;
}

size_t TrackPositions::NumBytes() const {
  return steps_.capacity() * sizeof(steps_[0]) + positions_.capacity() * sizeof(positions_[0]) +
         jumps_.capacity() * sizeof(jumps_[0]);
}

void TrackPositions::Reserve(size_t count) {
  steps_.reserve(count);
  positions_.reserve(count);
}

void TrackPositions::Shrink() {
  steps_.shrink_to_fit();
  positions_.shrink_to_fit();
  jumps_.shrink_to_fit();
}

}  // namespace rovio_sfm
