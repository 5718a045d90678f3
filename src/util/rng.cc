#include "rovio_sfm/util/rng.h"

#include <cmath>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

Rng::Rng(uint64_t seed) : state_(seed) {}

uint64_t Rng::Next() {
  uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Rng::Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

double Rng::Uniform(double low, double high) { return low + (high - low) * Uniform(); }

uint32_t Rng::UniformInt(uint32_t count) {
  ROVIO_CHECK(count > 0);
  return static_cast<uint32_t>((static_cast<uint64_t>(Next() >> 32) * count) >> 32);
}

double Rng::Gaussian() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return radius * std::cos(2.0 * M_PI * Uniform());
}

Rng Rng::Fork(uint64_t stream) { return Rng(Next() ^ (stream * 0xd1342543de82ef95ULL)); }

}  // namespace rovio_sfm
