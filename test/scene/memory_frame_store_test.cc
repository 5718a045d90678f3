#include "rovio_sfm/scene/memory_frame_store.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

std::shared_ptr<const FrameFeatures> FeaturesOf(size_t count) {
  auto features = std::make_shared<FrameFeatures>();
  features->keypoints.resize(count);
  return features;
}

TEST(MemoryFrameStore, AnswersNullForAnUnknownFrame) {
  MemoryFrameStore store;
  EXPECT_EQ(store.Get({{"rovio", 1, 0}, 0}), nullptr);
  store.Put({{"rovio", 1, 0}, 0}, FeaturesOf(1));
  EXPECT_EQ(store.Get({{"rovio", 1, 0}, 1}), nullptr);
  EXPECT_EQ(store.Get({{"rovio", 1, 1}, 0}), nullptr);
}

TEST(MemoryFrameStore, KeepsFramesOfDrivesApartAndSharesThem) {
  MemoryFrameStore store;
  const FrameId a{{"rovio", 1, 0}, 3}, b{{"rovio", 2, 0}, 3};
  const auto features = FeaturesOf(4);
  store.Put(a, features);
  store.Put(b, FeaturesOf(5));
  EXPECT_EQ(store.Get(a), features);
  EXPECT_EQ(store.Get(b)->keypoints.size(), 5u);
}

TEST(MemoryFrameStore, ReplacesAFrameThatIsPutAgain) {
  MemoryFrameStore store;
  const FrameId id{{"rovio", 1, 0}, 3};
  store.Put(id, FeaturesOf(4));
  store.Put(id, FeaturesOf(2));
  EXPECT_EQ(store.Get(id)->keypoints.size(), 2u);
}

}  // namespace
}  // namespace rovio_sfm
