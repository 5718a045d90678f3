#pragma once

#include <cstddef>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Whether they are of one type, length and metric.
bool AreComparable(const Descriptors& a, const Descriptors& b);

// The distance of two comparable descriptors, in their metric.
float DescriptorDistance(const Descriptors& a, size_t index_a, const Descriptors& b,
                         size_t index_b);

}  // namespace rovio_sfm
