#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// Descriptors as floats, row by row, with their squared lengths: whole numbers below 2^24.
struct FloatDescriptors {
  uint32_t length = 0;
  std::vector<float> values;
  std::vector<float> squared_norms;

  size_t Count() const { return squared_norms.size(); }
};

FloatDescriptors ToFloat(const Descriptors& descriptors);

// Calls visit(index of b, products of b with every a) for each b in order, computing the products
// in blocks by sgemm. Exact in whole numbers, so the order of summation does not matter. The first
// call sets OpenBLAS to one thread for the whole process.
void ForEachProductRow(const FloatDescriptors& a, const FloatDescriptors& b,
                       const std::function<void(size_t, const float*)>& visit);

}  // namespace rovio_sfm
