#pragma once

namespace rovio_sfm {

// The greatest memory of this process so far, MB.
double PeakMemoryMb();

}  // namespace rovio_sfm
