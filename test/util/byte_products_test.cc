#include "rovio_sfm/util/byte_products.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

using Bytes = std::vector<uint8_t>;

Bytes RandomBytes(size_t count, uint32_t length, uint64_t seed) {
  Rng rng(seed);
  Bytes bytes;
  for (size_t i = 0; i < count * length; ++i) {
    bytes.push_back(static_cast<uint8_t>(rng.UniformInt(256)));
  }
  return bytes;
}

TEST(ForEachProductRow, GivesExactProductsInOrderAcrossBlocks) {
  const Bytes a = RandomBytes(37, 128, 1), b = RandomBytes(300, 128, 2);
  size_t expected_index = 0;
  ForEachProductRow(ToFloatRows(a, 128), ToFloatRows(b, 128),
                    [&](size_t index, const float* products) {
                      EXPECT_EQ(index, expected_index++);
                      for (size_t i = 0; i < 37; ++i) {
                        int sum = 0;
                        for (size_t k = 0; k < 128; ++k) sum += a[i * 128 + k] * b[index * 128 + k];
                        EXPECT_EQ(products[i], static_cast<float>(sum));
                      }
                    });
  EXPECT_EQ(expected_index, 300u);
}

TEST(ForEachProductRow, VisitsNothingIfEitherIsEmpty) {
  const FloatRows some = ToFloatRows(RandomBytes(3, 64, 1), 64), none = ToFloatRows({}, 64);
  const auto fail = [](size_t, const float*) { FAIL(); };
  ForEachProductRow(some, none, fail);
  ForEachProductRow(none, some, fail);
}

TEST(ToFloatRows, KnowsTheSquaredNorms) {
  EXPECT_EQ(ToFloatRows({3, 4, 255, 255}, 2).squared_norms, (std::vector<float>{25.0f, 130050.0f}));
}

TEST(ToFloatRows, HasNoRowsWithoutALength) { EXPECT_EQ(ToFloatRows({}, 0).Count(), 0u); }

}  // namespace
}  // namespace rovio_sfm
