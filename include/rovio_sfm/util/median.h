#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

// The middle value of one at least; of an even number the upper of both in the middle.
template <typename Number>
Number Median(std::vector<Number> values) {
  ROVIO_CHECK(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace rovio_sfm
