#include "rovio_sfm/scene/frame_cache.h"

#include <gtest/gtest.h>

#include <vector>

namespace rovio_sfm {
namespace {

FrameId Id(uint32_t index) { return {{"rovio1", 1, 1}, index}; }

std::shared_ptr<const FrameFeatures> Features(size_t num_bytes) {
  auto features = std::make_shared<FrameFeatures>();
  features->descriptors.data.resize(num_bytes);
  return features;
}

TEST(FrameCache, HandsOutWhatWasPut) {
  FrameCache cache(10'000, nullptr);
  const auto features = Features(100);
  cache.Put(Id(1), features);
  EXPECT_EQ(cache.Get(Id(1)), features);
  EXPECT_EQ(cache.Get(Id(2)), nullptr);
}

TEST(FrameCache, ForgetsTheFrameLongestNotAskedFor) {
  FrameCache cache(10'000, nullptr);
  for (uint32_t i = 0; i < 3; ++i) cache.Put(Id(i), Features(3000));
  cache.Get(Id(0));
  cache.Put(Id(3), Features(3000));
  EXPECT_NE(cache.Get(Id(0)), nullptr);
  EXPECT_EQ(cache.Get(Id(1)), nullptr);
  EXPECT_LE(cache.NumBytes(), 10'000u);
}

TEST(FrameCache, StaysWithinItsSizeForEver) {
  FrameCache cache(10'000, nullptr);
  for (uint32_t i = 0; i < 1000; ++i) {
    cache.Put(Id(i % 50), Features(500 + 10 * (i % 7)));
    EXPECT_LE(cache.NumBytes(), 10'000u);
  }
}

TEST(FrameCache, FetchesWhatItForgot) {
  std::vector<uint32_t> fetched;
  FrameCache cache(10'000, [&](const FrameId& id) -> std::shared_ptr<const FrameFeatures> {
    fetched.push_back(id.index);
    return id.index == 9 ? nullptr : Features(200);
  });
  EXPECT_NE(cache.Get(Id(7)), nullptr);
  EXPECT_NE(cache.Get(Id(7)), nullptr);
  EXPECT_EQ(cache.Get(Id(9)), nullptr);
  EXPECT_EQ(fetched, (std::vector<uint32_t>{7, 9}));
  EXPECT_EQ(cache.NumFetched(), 1u);
}

TEST(FrameCache, KeepsOneFrameHoweverLarge) {
  FrameCache cache(10, nullptr);
  cache.Put(Id(1), Features(1000));
  EXPECT_NE(cache.Get(Id(1)), nullptr);
}

TEST(FrameCache, ReplacesAFrameThatIsPutAgain) {
  FrameCache cache(10'000, nullptr);
  cache.Put(Id(1), Features(5000));
  const auto second = Features(100);
  cache.Put(Id(1), second);
  EXPECT_EQ(cache.Get(Id(1)), second);
  EXPECT_LT(cache.NumBytes(), 1000u);
}

}  // namespace
}  // namespace rovio_sfm
