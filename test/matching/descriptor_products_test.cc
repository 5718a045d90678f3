#include "rovio_sfm/matching/descriptor_products.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

Descriptors RandomBytes(size_t count, uint32_t length, uint64_t seed) {
  Rng rng(seed);
  Descriptors descriptors;
  descriptors.length = length;
  for (size_t i = 0; i < count * length; ++i) {
    descriptors.data.push_back(static_cast<uint8_t>(rng.UniformInt(256)));
  }
  return descriptors;
}

TEST(ForEachProductRow, GivesExactProductsInOrderAcrossBlocks) {
  const Descriptors a = RandomBytes(37, 128, 1), b = RandomBytes(300, 128, 2);
  size_t expected_index = 0;
  ForEachProductRow(ToFloat(a), ToFloat(b), [&](size_t index, const float* products) {
    EXPECT_EQ(index, expected_index++);
    for (size_t i = 0; i < a.Count(); ++i) {
      int sum = 0;
      for (uint32_t k = 0; k < a.length; ++k) sum += a.Row(i)[k] * b.Row(index)[k];
      EXPECT_EQ(products[i], static_cast<float>(sum));
    }
  });
  EXPECT_EQ(expected_index, 300u);
}

TEST(ForEachProductRow, VisitsNothingIfEitherIsEmpty) {
  const Descriptors some = RandomBytes(3, 64, 1), none = RandomBytes(0, 64, 1);
  const auto fail = [](size_t, const float*) { FAIL(); };
  ForEachProductRow(ToFloat(some), ToFloat(none), fail);
  ForEachProductRow(ToFloat(none), ToFloat(some), fail);
}

TEST(ToFloat, KnowsTheSquaredNorms) {
  Descriptors descriptors;
  descriptors.length = 2;
  descriptors.data = {3, 4, 255, 255};
  EXPECT_EQ(ToFloat(descriptors).squared_norms, (std::vector<float>{25.0f, 130050.0f}));
}

}  // namespace
}  // namespace rovio_sfm
