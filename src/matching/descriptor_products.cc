#include "rovio_sfm/matching/descriptor_products.h"

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

FloatDescriptors ToFloat(const Descriptors& descriptors) {
  FloatDescriptors result;
  result.length = descriptors.length;
  result.values.assign(descriptors.data.begin(), descriptors.data.end());
  result.squared_norms.reserve(descriptors.Count());
  for (size_t i = 0; i < descriptors.Count(); ++i) {
    const uint8_t* row = descriptors.Row(i);
    uint32_t sum = 0;
    for (uint32_t k = 0; k < descriptors.length; ++k) sum += uint32_t{row[k]} * row[k];
    result.squared_norms.push_back(static_cast<float>(sum));
  }
  return result;
}

void ForEachProductRow(const FloatDescriptors& a, const FloatDescriptors& b,
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
