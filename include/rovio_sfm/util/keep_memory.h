#pragma once

namespace rovio_sfm {

// From now on the process keeps the memory that it frees for what it allocates next: to have the
// kernel clear the same pages again for every picture costs more than blurring it. For mains.
void KeepFreedMemory();

}  // namespace rovio_sfm
