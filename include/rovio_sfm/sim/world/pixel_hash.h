#pragma once

#include <cstdint>

namespace rovio_sfm::sim {

// A random number of a pixel and sample: the same in any order of rendering.
inline uint64_t HashPixel(uint64_t seed, uint32_t row, uint32_t col, uint32_t sample) {
  uint64_t z =
      seed ^ (static_cast<uint64_t>(row) << 40 ^ static_cast<uint64_t>(col) << 16 ^ sample);
  z = (z + 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 29)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 32);
}

// The n-th 16 bits (0 … 3) as a number in [0, 1).
inline float UnitFromHash(uint64_t hash, int n) {
  return static_cast<float>((hash >> (16 * n)) & 0xffff) / 65536.0f;
}

}  // namespace rovio_sfm::sim
