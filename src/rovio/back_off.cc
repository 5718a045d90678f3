#include "rovio_sfm/rovio/back_off.h"

#include <algorithm>

namespace rovio_sfm {

bool BackOffOptions::IsValid(std::string* error) const {
  if (first_delay_s >= 0.01 && max_delay_s >= first_delay_s && max_delay_s <= 600.0 &&
      factor > 1.0 && factor <= 10.0) {
    return true;
  }
  *error = "back-off: first_delay_s >= 0.01 <= max_delay_s <= 600, factor above 1 up to 10";
  return false;
}

double BackOff::NextDelaySeconds() {
  const double delay_s = next_delay_s_;
  next_delay_s_ = std::min(next_delay_s_ * options_.factor, options_.max_delay_s);
  return delay_s;
}

void BackOff::Reset() { next_delay_s_ = options_.first_delay_s; }

}  // namespace rovio_sfm
