#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace rovio_sfm {

// Rows of numbers, with the squared length of each. Of bytes (descriptors) these are whole numbers
// below 2^24.
struct FloatRows {
  uint32_t length = 0;
  std::vector<float> values;
  std::vector<float> squared_norms;

  size_t Count() const { return squared_norms.size(); }
};

// data: rows of `length` bytes.
FloatRows ToFloatRows(const std::vector<uint8_t>& data, uint32_t length);

// Of two rows of `length` bytes; at most 33 000 of them, so that it is an int.
int SquaredDistance(const uint8_t* a, const uint8_t* b, uint32_t length);

// Calls visit(index of b, products of b with every a) for each b in order, computing the products
// in blocks by sgemm. Exact in whole numbers, so the order of summation does not matter. The first
// call sets OpenBLAS to one thread for the whole process. May run on several threads at once.
void ForEachProductRow(const FloatRows& a, const FloatRows& b,
                       const std::function<void(size_t, const float*)>& visit);

}  // namespace rovio_sfm
