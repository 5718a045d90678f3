#include "rovio_sfm/sim/http/robot_access.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm::sim {

RobotAccess::RobotAccess(RobotBackend& robot, Clock now_ns, Guarded<Quirks>& quirks)
    : robot_(robot), now_ns_(std::move(now_ns)), quirks_(quirks) {}

std::optional<CapturedImage> RobotAccess::Capture(const CameraSettings& settings) {
  int64_t time_ns = 0;
  {
    const MutexLock lock(mutex_);
    Advance();
    time_ns = time_ns_;
  }
  return robot_.Capture(time_ns, settings);
}

// The last of the robot's own reads since the previous call is the only one that matters.
void RobotAccess::Advance() {
  const int64_t now = std::max(now_ns_(), time_ns_);
  const double rate_hz =
      quirks_.With([](Quirks& quirks) { return quirks.Value(Quirk::kLostTicks); });
  if (rate_hz > 0.0) {
    const auto period_ns = std::max<int64_t>(1, std::llround(1e9 / rate_hz));
    const int64_t own_read_ns = now / period_ns * period_ns;
    if (own_read_ns > time_ns_) {
      robot_.AdvanceTo(own_read_ns);
      robot_.ReadMcu();
    }
  }
  robot_.AdvanceTo(now);
  time_ns_ = now;
}

}  // namespace rovio_sfm::sim
