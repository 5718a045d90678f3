#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rovio_sfm/io/odometry_file.h"

namespace rovio_sfm {

// The wheel odometry of one robot over the last while, by rising stamp. Not thread-safe.
class OdometryBuffer {
 public:
  // Keeps at least `memory_ns`; samples further apart than max_gap_ns are not interpolated.
  OdometryBuffer(int64_t memory_ns, int64_t max_gap_ns)
      : memory_ns_(memory_ns), max_gap_ns_(max_gap_ns) {}

  // A sample that is repeated or late is ignored; where time jumped back (scene/stamp_order.h) what
  // came earlier is forgotten.
  void Add(const StampedOdometry& sample);

  // odom_from_base at the stamp; nothing outside of what was received or in a gap.
  std::optional<OdometrySample> At(int64_t stamp_ns) const;

  bool IsEmpty() const { return samples_.empty(); }
  // True if no later sample can change At(stamp_ns).
  bool Covers(int64_t stamp_ns) const {
    return !samples_.empty() && samples_.back().stamp_ns >= stamp_ns;
  }
  void Clear() { samples_.clear(); }

 private:
  void ForgetOld();

  int64_t memory_ns_;
  int64_t max_gap_ns_;
  std::vector<StampedOdometry> samples_;
};

}  // namespace rovio_sfm
