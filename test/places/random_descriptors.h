#pragma once

#include <cstddef>
#include <cstdint>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

inline Descriptors RandomDescriptors(size_t count, uint64_t seed) {
  Rng rng(seed);
  Descriptors descriptors;
  descriptors.type = DescriptorType::kSift;
  descriptors.length = 128;
  for (size_t i = 0; i < count * 128; ++i) {
    descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(200)));
  }
  return descriptors;
}

}  // namespace rovio_sfm
