#include "rovio_sfm/util/byte_products.h"

#include <cblas.h>

#include <algorithm>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr size_t kBlockRows = 128;  // the block of products stays in the second-level cache

void UseOneBlasThread() {
  static const bool done = [] {
    openblas_set_num_threads(1);
    return true;
  }();
  (void)done;
}

}  // namespace

FloatRows ToFloatRows(const std::vector<uint8_t>& data, uint32_t length) {
  FloatRows rows;
  rows.length = length;
  if (length == 0) return rows;
  rows.values.assign(data.begin(), data.end());
  rows.squared_norms.reserve(data.size() / length);
  for (size_t begin = 0; begin + length <= data.size(); begin += length) {
    uint32_t sum = 0;
    for (uint32_t k = 0; k < length; ++k) sum += uint32_t{data[begin + k]} * data[begin + k];
    rows.squared_norms.push_back(static_cast<float>(sum));
  }
  return rows;
}

int SquaredDistance(const uint8_t* a, const uint8_t* b, uint32_t length) {
  int sum = 0;
  for (uint32_t i = 0; i < length; ++i) {
    const int difference = int{a[i]} - int{b[i]};
    sum += difference * difference;
  }
  return sum;
}

void ForEachProductRow(const FloatRows& a, const FloatRows& b,
                       const std::function<void(size_t, const float*)>& visit) {
  ROVIO_CHECK(a.length == b.length);
  if (a.Count() == 0 || b.Count() == 0) return;
  UseOneBlasThread();
  std::vector<float> products(kBlockRows * a.Count());
  const auto columns = static_cast<int>(a.Count()), length = static_cast<int>(a.length);
  for (size_t begin = 0; begin < b.Count(); begin += kBlockRows) {
    const size_t rows = std::min(kBlockRows, b.Count() - begin);
    cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasTrans, static_cast<int>(rows), columns, length,
                1.0f, b.values.data() + begin * b.length, length, a.values.data(), length, 0.0f,
                products.data(), columns);
    for (size_t row = 0; row < rows; ++row) visit(begin + row, &products[row * a.Count()]);
  }
}

}  // namespace rovio_sfm
