#pragma once

#include <cstdint>

namespace rovio_sfm {

// A small seeded generator (SplitMix64) with its own distributions, so that the same seed gives the
// same numbers with every standard library. Always passed as an argument. Not thread-safe.
class Rng {
 public:
  explicit Rng(uint64_t seed);

  uint64_t Next();
  double Uniform();                         // [0, 1)
  double Uniform(double low, double high);  // [low, high)
  uint32_t UniformInt(uint32_t count);      // 0 … count-1; count > 0
  double Gaussian();                        // mean 0, standard deviation 1
  Rng Fork(uint64_t stream);                // an independent generator; advances this one

 private:
  uint64_t state_;
};

}  // namespace rovio_sfm
