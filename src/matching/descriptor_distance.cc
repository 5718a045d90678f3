#include "rovio_sfm/matching/descriptor_distance.h"

#include <cmath>
#include <opencv2/core/hal/hal.hpp>

#include "rovio_sfm/util/byte_products.h"

namespace rovio_sfm {

bool AreComparable(const Descriptors& a, const Descriptors& b) {
  return a.type == b.type && a.length == b.length && a.metric == b.metric;
}

float DescriptorDistance(const Descriptors& a, size_t index_a, const Descriptors& b,
                         size_t index_b) {
  const uint8_t *row_a = a.Row(index_a), *row_b = b.Row(index_b);
  if (a.metric == DescriptorMetric::kHamming) {
    return static_cast<float>(cv::hal::normHamming(row_a, row_b, static_cast<int>(a.length)));
  }
  return std::sqrt(static_cast<float>(SquaredDistance(row_a, row_b, a.length)));
}

}  // namespace rovio_sfm
