#include "rovio_sfm/rovio/back_off.h"

#include <algorithm>

namespace rovio_sfm {

double BackOff::NextDelaySeconds() {
  const double delay_s = next_delay_s_;
  next_delay_s_ = std::min(next_delay_s_ * options_.factor, options_.max_delay_s);
  return delay_s;
}

void BackOff::Reset() { next_delay_s_ = options_.first_delay_s; }

}  // namespace rovio_sfm
