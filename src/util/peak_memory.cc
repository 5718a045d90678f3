#include "rovio_sfm/util/peak_memory.h"

#include <sys/resource.h>

namespace rovio_sfm {

double PeakMemoryMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace rovio_sfm
