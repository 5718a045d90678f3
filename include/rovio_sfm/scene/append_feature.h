#pragma once

#include <cstddef>
#include <cstdint>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Appends one feature, with its colour and its descriptor, to others of the same type.
inline void AppendFeature(const FrameFeatures& from, size_t index, FrameFeatures* to) {
  to->keypoints.push_back(from.keypoints[index]);
  to->colors.push_back(from.colors[index]);
  const uint8_t* row = from.descriptors.Row(index);
  to->descriptors.data.insert(to->descriptors.data.end(), row, row + from.descriptors.length);
}

}  // namespace rovio_sfm
