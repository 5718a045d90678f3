#include "rovio_sfm/util/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rovio_sfm {
namespace {

TEST(Rng, IsSplitMix64) {
  Rng rng(1234567);  // the reference implementation's test vector
  EXPECT_EQ(rng.Next(), 6457827717110365317ULL);
  EXPECT_EQ(rng.Next(), 3203168211198807973ULL);
  EXPECT_EQ(rng.Next(), 9817491932198370423ULL);
}

TEST(Rng, SameSeedGivesTheSameNumbers) {
  Rng a(7), b(7), c(8);
  EXPECT_EQ(a.Gaussian(), b.Gaussian());
  EXPECT_EQ(a.Next(), b.Next());
  EXPECT_NE(a.Next(), c.Next());
}

TEST(Rng, UniformStaysInItsRangeAndFillsIt) {
  Rng rng(1);
  double sum = 0.0, least = 10.0, most = -10.0;
  for (int i = 0; i < 100000; ++i) {
    const double value = rng.Uniform(-2.0, 3.0);
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, -2.0);
  EXPECT_LT(most, 3.0);
  EXPECT_LT(least, -1.99);
  EXPECT_GT(most, 2.99);
  EXPECT_NEAR(sum / 100000, 0.5, 0.03);
}

TEST(Rng, UniformIntIsEven) {
  Rng rng(1);
  std::array<int, 5> counts{};
  for (int i = 0; i < 10000; ++i) ++counts.at(rng.UniformInt(5));
  for (const int count : counts) EXPECT_NEAR(count, 2000, 200);
  EXPECT_EQ(rng.UniformInt(1), 0u);
}

TEST(Rng, GaussianHasMeanZeroAndUnitDeviation) {
  Rng rng(1);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double value = rng.Gaussian();
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / 20000, 0.0, 0.03);
  EXPECT_NEAR(squares / 20000, 1.0, 0.04);
}

TEST(Rng, ForksAreIndependentAndReproducible) {
  Rng a(7), b(7);
  Rng fork_a = a.Fork(1), fork_b = b.Fork(1);
  EXPECT_EQ(fork_a.Next(), fork_b.Next());
  Rng c(7);
  EXPECT_NE(c.Fork(2).Next(), Rng(7).Fork(1).Next());
}

TEST(RngDeathTest, RefusesAnEmptyRange) {
  Rng rng(1);
  EXPECT_DEATH(rng.UniformInt(0), "check failed");
}

}  // namespace
}  // namespace rovio_sfm
