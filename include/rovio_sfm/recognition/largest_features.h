#pragma once

#include <cstddef>
#include <memory>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// The `count` largest features, in their order; of equally large ones the first. The same object,
// if there are no more. Large ones are found again from farther away, so that few of them tell
// whether two images are worth matching whole (Wu, Towards Linear-Time Incremental Structure from
// Motion, §3).
std::shared_ptr<const FrameFeatures> LargestFeatures(std::shared_ptr<const FrameFeatures> features,
                                                     size_t count);

}  // namespace rovio_sfm
