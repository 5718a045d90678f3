#pragma once

#include <time.h>

#include <chrono>
#include <cstdint>

namespace rovio_sfm {

// A clock that never jumps, for programs and nodes to measure how long something takes; the core
// reads none. Since some moment before the program began.
inline int64_t SteadyNs() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

// The same, but it goes on while the machine is suspended: how old a command is.
inline int64_t BootNs() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

inline double SteadySeconds() { return 1e-9 * static_cast<double>(SteadyNs()); }

}  // namespace rovio_sfm
