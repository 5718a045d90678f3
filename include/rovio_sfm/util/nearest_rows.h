#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "rovio_sfm/util/byte_products.h"

namespace rovio_sfm {

// Finds the nearest of many rows of bytes (descriptors), exactly. Coordinates along the few axes
// on which the rows spread most bound how near another row may lie, at a part of the cost of all
// bytes: most rows are ruled out before their distance is computed. Immutable, so any thread may
// use it.
class NearestRows {
 public:
  struct Two {
    uint32_t best = 0;                  // the first of equals
    int least = 0, second = INT32_MAX;  // squared distances; of one row alone INT32_MAX
  };

  NearestRows() = default;
  // At least one row of `length` bytes, 1 to 512.
  NearestRows(std::vector<uint8_t> rows, uint32_t length);

  // Calls visit(index, the two nearest rows) for each row of `points`, in order.
  void ForEachTwo(const std::vector<uint8_t>& points,
                  const std::function<void(size_t, const Two&)>& visit) const;

 private:
  class Search;

  std::vector<uint8_t> rows_;
  uint32_t length_ = 0;
  Eigen::RowVectorXf mean_;
  Eigen::MatrixXf axes_;  // columns
  FloatRows short_rows_;
  float largest_norm_ = 0.0f;
};

}  // namespace rovio_sfm
