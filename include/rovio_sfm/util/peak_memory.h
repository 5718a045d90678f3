#pragma once

#include <sys/resource.h>

namespace rovio_sfm {

// The greatest memory of this process so far, MB.
inline double PeakMemoryMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace rovio_sfm
