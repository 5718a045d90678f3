#include "rovio_sfm/matching/descriptor_distance.h"

#include <cmath>
#include <opencv2/core/hal/hal.hpp>

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
  int sum = 0;
  for (uint32_t i = 0; i < a.length; ++i) {
    const int difference = int{row_a[i]} - int{row_b[i]};
    sum += difference * difference;
  }
  return std::sqrt(static_cast<float>(sum));
}

}  // namespace rovio_sfm
