#include "rovio_sfm/rovio/image_statistics.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {

void ImageStatistics::Add(int64_t stamp_ns, int64_t complete_ns) {
  if (has_last_) {
    const double interval_s = static_cast<double>(stamp_ns - last_stamp_ns_) * 1e-9;
    ++num_intervals_;
    interval_sum_s_ += interval_s;
    interval_square_sum_ += interval_s * interval_s;
  }
  has_last_ = true;
  last_stamp_ns_ = stamp_ns;
  const double transfer_s = static_cast<double>(complete_ns - stamp_ns) * 1e-9;
  ++num_images_;
  transfer_sum_s_ += transfer_s;
  max_transfer_s_ = std::max(max_transfer_s_, transfer_s);
}

ImageFigures ImageStatistics::Take() {
  ImageFigures figures;
  figures.count = num_images_;
  if (num_intervals_ > 0) {
    const double count = static_cast<double>(num_intervals_);
    figures.mean_interval_s = interval_sum_s_ / count;
    const double variance =
        interval_square_sum_ / count - figures.mean_interval_s * figures.mean_interval_s;
    figures.jitter_s = std::sqrt(std::max(variance, 0.0));
  }
  if (num_images_ > 0) figures.mean_transfer_s = transfer_sum_s_ / static_cast<double>(num_images_);
  figures.max_transfer_s = max_transfer_s_;
  const bool has_last = has_last_;
  const int64_t last_stamp_ns = last_stamp_ns_;
  *this = {};
  has_last_ = has_last;
  last_stamp_ns_ = last_stamp_ns;
  return figures;
}

}  // namespace rovio_sfm
