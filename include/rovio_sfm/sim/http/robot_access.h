#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "rovio_sfm/sim/http/guarded.h"
#include "rovio_sfm/sim/http/quirks.h"
#include "rovio_sfm/sim/robot/robot_backend.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

// Nanoseconds since the Unix epoch, never running back. May be called from any thread.
using Clock = std::function<int64_t()>;

// The one way to the robot for many connections: takes the lock, brings the robot up to the clock,
// then runs the call. Also plays the robot's own software, whose reads of the wheel counters steal
// ticks (quirk lost_ticks). Thread-safe.
class RobotAccess {
 public:
  RobotAccess(RobotBackend& robot, Clock now_ns, Guarded<Quirks>& quirks);

  template <typename Function>
  auto With(Function&& function) {
    const MutexLock lock(mutex_);
    Advance();
    return std::forward<Function>(function)(robot_);
  }

  // Brings the robot up to the clock, then renders without the lock.
  std::optional<CapturedImage> Capture(const CameraSettings& settings);

  int64_t now_ns() const { return now_ns_(); }

 private:
  void Advance() REQUIRES(mutex_);

  RobotBackend& robot_;
  const Clock now_ns_;
  Guarded<Quirks>& quirks_;
  Mutex mutex_;
  int64_t time_ns_ GUARDED_BY(mutex_) = 0;  // where the robot stands
};

}  // namespace rovio_sfm::sim
