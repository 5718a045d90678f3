#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// Positions by track, in the order in which they came. Adjustments bring them by rising track, so
// that the step from the one before is kept in place of a track: a journal holds many of these.
class TrackPositions {
 public:
  void Add(TrackId track, const Eigen::Vector3d& position);

  std::vector<std::pair<TrackId, Eigen::Vector3d>> List() const;

  size_t size() const { return steps_.size(); }
  size_t NumBytes() const;
  void Reserve(size_t count);
  void Shrink();  // no more come

 private:
  static constexpr uint8_t kJump = 0;  // backward, or too far

  std::vector<uint8_t> steps_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<TrackId> jumps_;
  TrackId last_ = 0;
};

}  // namespace rovio_sfm
