#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/util/byte_products.h"
#include "rovio_sfm/util/nearest_rows.h"

namespace rovio_sfm {

// The visual words: centres of clusters of descriptors, themselves descriptors as bytes (§4.2.2).
// Immutable, so any thread may use it.
class Vocabulary {
 public:
  // An empty vocabulary, for a model yet to be filled.
  Vocabulary() = default;
  // Words of metric L2.
  explicit Vocabulary(Descriptors words);

  size_t NumWords() const { return words_.Count(); }
  const Descriptors& Words() const { return words_; }

  // False for descriptors of another type or length; reason (may be null) then names both.
  bool Accepts(const Descriptors& descriptors, std::string* reason) const;

  // The nearest word of each descriptor, the first of equals. The vocabulary must accept the
  // descriptors.
  std::vector<uint32_t> Quantize(const Descriptors& descriptors) const;

 private:
  Descriptors words_;
  NearestRows nearest_;
};

// The nearest row of `centers` for each row of `points`, the first of equals, and its squared
// distance.
struct NearestCenter {
  uint32_t index = 0;
  float squared_distance = 0.0f;
};
std::vector<NearestCenter> FindNearestCenters(const FloatRows& centers, const FloatRows& points);

}  // namespace rovio_sfm
