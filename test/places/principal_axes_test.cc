#include "rovio_sfm/places/principal_axes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "random_descriptors.h"

namespace rovio_sfm {
namespace {

int SquaredDistance(const Descriptors& a, size_t i, const Descriptors& b, size_t j) {
  int sum = 0;
  for (uint32_t k = 0; k < a.length; ++k) {
    const int difference = int{a.Row(i)[k]} - int{b.Row(j)[k]};
    sum += difference * difference;
  }
  return sum;
}

double SquaredDistance(const FloatRows& a, size_t i, const FloatRows& b, size_t j) {
  double product = 0.0;
  for (uint32_t k = 0; k < a.length; ++k) {
    product += double{a.values[i * a.length + k]} * b.values[j * b.length + k];
  }
  return double{a.squared_norms[i]} + b.squared_norms[j] - 2.0 * product;
}

TEST(PrincipalAxes, BoundTheDistanceFromBelow) {
  const Descriptors a = RandomDescriptors(40, 1), b = RandomDescriptors(50, 2);
  for (const int count : {0, 1, 20, 127}) {
    const PrincipalAxes axes(a, count);
    const FloatRows short_a = axes.Shorten(a), short_b = axes.Shorten(b);
    ASSERT_EQ(short_a.length, static_cast<uint32_t>(count) + 1);
    for (size_t i = 0; i < a.Count(); ++i) {
      for (size_t j = 0; j < b.Count(); ++j) {
        EXPECT_LE(SquaredDistance(short_a, i, short_b, j), SquaredDistance(a, i, b, j) + 2.0);
      }
    }
  }
}

TEST(PrincipalAxes, TellTheDistanceWhereTheyAreAll) {
  const Descriptors a = RandomDescriptors(40, 3), b = RandomDescriptors(50, 4);
  const PrincipalAxes axes(a, 1000);
  const FloatRows short_a = axes.Shorten(a), short_b = axes.Shorten(b);
  EXPECT_EQ(short_a.length, a.length + 1);
  for (size_t i = 0; i < a.Count(); ++i) {
    for (size_t j = 0; j < b.Count(); ++j) {
      EXPECT_NEAR(SquaredDistance(short_a, i, short_b, j), SquaredDistance(a, i, b, j), 200.0);
    }
  }
}

// Two kinds that differ in one byte: its axis is the first, and tells them apart.
TEST(PrincipalAxes, ComeByTheirSpread) {
  Descriptors rows{DescriptorType::kSift, DescriptorMetric::kL2, 4, {}};
  for (const int high : {0, 200, 0, 200}) {
    rows.data.insert(rows.data.end(), {9, static_cast<uint8_t>(high), 9, 9});
  }
  const FloatRows shortened = PrincipalAxes(rows, 1).Shorten(rows);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::abs(shortened.values[2 * i]), 100.0f, 1e-3f);
    EXPECT_NEAR(shortened.values[2 * i + 1], 0.0f, 0.1f);
  }
  EXPECT_NEAR(SquaredDistance(shortened, 0, shortened, 1), 40000.0, 1.0);
  EXPECT_NEAR(SquaredDistance(shortened, 0, shortened, 2), 0.0, 1.0);
}

TEST(PrincipalAxes, ShortenNothingToNothing) {
  const PrincipalAxes axes(RandomDescriptors(5, 5), 3);
  EXPECT_EQ(axes.Shorten(RandomDescriptors(0, 6)).Count(), 0u);
}

}  // namespace
}  // namespace rovio_sfm
