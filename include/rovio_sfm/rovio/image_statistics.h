#pragma once

#include <cstdint>

namespace rovio_sfm {

// Figures of the images of one reporting period.
struct ImageFigures {
  uint64_t count = 0;
  double mean_interval_s = 0.0;
  double jitter_s = 0.0;         // standard deviation of the interval
  double mean_transfer_s = 0.0;  // from the first byte to the last
  double max_transfer_s = 0.0;
};

// Collects arrival times of images. Not thread-safe.
class ImageStatistics {
 public:
  // Stamp of the first byte and time of the last.
  void Add(int64_t first_byte_ns, int64_t complete_ns);

  // The figures since the last call; begins anew.
  ImageFigures Take();

 private:
  int64_t last_stamp_ns_ = 0;
  bool has_last_ = false;
  uint64_t num_images_ = 0;
  uint64_t num_intervals_ = 0;
  double interval_sum_s_ = 0.0;
  double interval_square_sum_ = 0.0;
  double transfer_sum_s_ = 0.0;
  double max_transfer_s_ = 0.0;
};

}  // namespace rovio_sfm
