#pragma once

#include <cstddef>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// The distance of two descriptors of one type and length, in their metric.
float DescriptorDistance(const Descriptors& a, size_t index_a, const Descriptors& b,
                         size_t index_b);

}  // namespace rovio_sfm
