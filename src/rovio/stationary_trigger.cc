#include "rovio_sfm/rovio/stationary_trigger.h"

namespace rovio_sfm {

void StationaryTrigger::Note(bool is_moving, int64_t now_ns) {
  if (is_moving) has_image_ = false;
  if (!is_known_ || (is_moving_ && !is_moving)) rest_since_ns_ = now_ns;
  is_moving_ = is_moving;
  is_known_ = true;
}

bool StationaryTrigger::WantsImage(int64_t now_ns) const {
  return is_known_ && !is_moving_ && !has_image_ && now_ns - rest_since_ns_ >= options_.rest_ns;
}

bool StationaryTrigger::Accept(int64_t stamp_ns) {
  if (!WantsImage(stamp_ns)) return false;
  has_image_ = true;
  return true;
}

}  // namespace rovio_sfm
