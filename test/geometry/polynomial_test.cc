#include "rovio_sfm/geometry/polynomial.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

std::vector<double> FromRoots(const std::vector<double>& roots) {
  std::vector<double> coefficients = {1.0};
  for (const double root : roots) {
    coefficients.insert(coefficients.begin(), 0.0);
    for (size_t i = 0; i + 1 < coefficients.size(); ++i) {
      coefficients[i] -= root * coefficients[i + 1];
    }
  }
  return coefficients;
}

void ExpectRoots(const std::vector<double>& coefficients, const std::vector<double>& expected) {
  const std::vector<double> roots = FindRealRoots(coefficients);
  ASSERT_EQ(roots.size(), expected.size());
  for (size_t i = 0; i < roots.size(); ++i) {
    EXPECT_NEAR(roots[i], expected[i], 1e-7 * (1.0 + std::abs(expected[i])));
  }
}

TEST(FindRealRoots, FindsSmallAndLargeRoots) {
  ExpectRoots(FromRoots({0.5}), {0.5});
  ExpectRoots(FromRoots({-700.0, -0.3, 0.2, 5.0, 40.0}), {-700.0, -0.3, 0.2, 5.0, 40.0});
}

TEST(FindRealRoots, IgnoresComplexRoots) {
  ExpectRoots({1.0, 0.0, 1.0}, {});
  ExpectRoots({-2.0, 1.0, -2.0, 1.0}, {2.0});  // (x^2 + 1)(x - 2)
}

TEST(FindRealRoots, FindsTenRandomRoots) {
  Rng rng(9);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> roots;
    for (int i = 0; i < 10; ++i) roots.push_back(-2.0 + 0.4 * i + rng.Uniform(0.0, 0.3));
    ExpectRoots(FromRoots(roots), roots);
  }
}

TEST(FindRealRoots, TellsNearRootsApart) {
  ExpectRoots(FromRoots({-3.0005, -3.0, 0.25, 0.2501, 7.0}), {-3.0005, -3.0, 0.25, 0.2501, 7.0});
}

TEST(FindRealRoots, FindsRootsAtZeroAndOne) {
  ExpectRoots(FromRoots({-1.0, 0.0, 1.0}), {-1.0, 0.0, 1.0});
}

TEST(FindRealRoots, AcceptsVanishingLeadingCoefficients) {
  ExpectRoots({-1.0, 2.0, 0.0, 0.0}, {0.5});
}

TEST(FindRealRoots, IsEmptyForConstants) {
  EXPECT_TRUE(FindRealRoots({}).empty());
  EXPECT_TRUE(FindRealRoots({3.0}).empty());
}

}  // namespace
}  // namespace rovio_sfm
