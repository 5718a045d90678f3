#include "rovio_sfm/util/nearest_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

using Bytes = std::vector<uint8_t>;
using Two = NearestRows::Two;

Bytes RandomBytes(size_t count, uint32_t length, uint64_t seed, uint32_t end = 256) {
  Rng rng(seed);
  Bytes bytes(count * length);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(rng.UniformInt(end));
  return bytes;
}

Two ByBruteForce(const Bytes& rows, const uint8_t* point, uint32_t length) {
  Two two{0, INT32_MAX, INT32_MAX};
  for (uint32_t i = 0; i < rows.size() / length; ++i) {
    int distance = 0;
    for (uint32_t k = 0; k < length; ++k) {
      const int difference = int{rows[i * length + k]} - int{point[k]};
      distance += difference * difference;
    }
    if (distance < two.least) two.best = i;
    two.second = std::min(two.second, std::max(distance, two.least));
    two.least = std::min(distance, two.least);
  }
  return two;
}

void ExpectExact(const Bytes& rows, const Bytes& points, uint32_t length) {
  size_t next = 0;
  NearestRows(rows, length).ForEachTwo(points, [&](size_t i, const Two& found) {
    EXPECT_EQ(i, next++);
    const Two expected = ByBruteForce(rows, &points[i * length], length);
    EXPECT_EQ(found.best, expected.best) << i;
    EXPECT_EQ(found.least, expected.least) << i;
    EXPECT_EQ(found.second, expected.second) << i;
  });
  EXPECT_EQ(next, points.size() / length);
}

TEST(NearestRows, FindsTheTwoNearestOfAny) {
  ExpectExact(RandomBytes(300, 128, 1), RandomBytes(200, 128, 2), 128);
  ExpectExact(RandomBytes(300, 64, 3, 20), RandomBytes(200, 64, 4, 20), 64);
  ExpectExact(RandomBytes(100, 1, 5), RandomBytes(50, 1, 6), 1);
}

// Most are ruled out by a part of the coordinates.
TEST(NearestRows, FindsTheTwoNearestWhereRowsGather) {
  const Bytes rows = RandomBytes(400, 128, 7);
  Bytes points = rows;
  Rng rng(8);
  for (uint8_t& byte : points) byte = static_cast<uint8_t>(byte / 2 + rng.UniformInt(128));
  ExpectExact(rows, points, 128);
}

// Rows as long as bytes allow, where floats round most.
TEST(NearestRows, FindsTheTwoNearestOfTheLongest) {
  Bytes rows = RandomBytes(200, 512, 9, 2), points = RandomBytes(100, 512, 10, 2);
  for (Bytes* bytes : {&rows, &points}) {
    for (uint8_t& byte : *bytes) byte = byte == 0 ? 0 : 255;
  }
  ExpectExact(rows, points, 512);
}

TEST(NearestRows, TakesTheFirstOfEquals) {
  Bytes rows = RandomBytes(50, 16, 11, 3);
  rows.insert(rows.end(), rows.begin(), rows.end());
  ExpectExact(rows, rows, 16);
}

// More than are looked at for the axes.
TEST(NearestRows, FindsTheTwoNearestOfMany) {
  ExpectExact(RandomBytes(11'000, 8, 12), RandomBytes(20, 8, 13), 8);
}

TEST(NearestRows, HasNoSecondOfOneRow) {
  ExpectExact(RandomBytes(1, 32, 14), RandomBytes(5, 32, 15), 32);
}

TEST(NearestRows, VisitsNothingForNoPoints) {
  const auto fail = [](size_t, const Two&) { FAIL(); };
  NearestRows(RandomBytes(3, 8, 16), 8).ForEachTwo({}, fail);
}

}  // namespace
}  // namespace rovio_sfm
