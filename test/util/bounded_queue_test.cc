#include "rovio_sfm/util/bounded_queue.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace rovio_sfm {
namespace {

TEST(BoundedQueue, PopsInOrderOfPush) {
  BoundedQueue<int> queue(3, WhenFull::kBlock);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(queue.Push(i));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.Pop(), i);
  EXPECT_EQ(queue.TryPop(), std::nullopt);
}

TEST(BoundedQueue, DropsTheOldestWhenFullAndCountsIt) {
  BoundedQueue<int> queue(2, WhenFull::kDropOldest);
  for (int i = 0; i < 5; ++i) queue.Push(i);
  EXPECT_EQ(queue.NumDropped(), 3u);
  EXPECT_EQ(queue.Size(), 2u);
  EXPECT_EQ(queue.Pop(), 3);
  EXPECT_EQ(queue.Pop(), 4);
}

TEST(BoundedQueue, AFullBlockingQueueWaitsForRoomAndDropsNothing) {
  BoundedQueue<int> queue(1, WhenFull::kBlock);
  std::thread producer([&queue] {
    for (int i = 0; i < 100; ++i) queue.Push(i);
    queue.Close();
  });
  int expected = 0;
  while (const std::optional<int> item = queue.Pop()) EXPECT_EQ(*item, expected++);
  producer.join();
  EXPECT_EQ(expected, 100);
  EXPECT_EQ(queue.NumDropped(), 0u);
}

TEST(BoundedQueue, AClosedQueueRefusesItemsAndGivesOutWhatItHolds) {
  BoundedQueue<int> queue(2, WhenFull::kBlock);
  queue.Push(7);
  queue.Close();
  EXPECT_FALSE(queue.Push(8));
  EXPECT_EQ(queue.Pop(), 7);
  EXPECT_EQ(queue.Pop(), std::nullopt);
}

TEST(BoundedQueue, CloseWakesAProducerThatWaits) {
  BoundedQueue<int> queue(1, WhenFull::kBlock);
  queue.Push(1);
  std::thread producer([&queue] { EXPECT_FALSE(queue.Push(2)); });
  queue.Close();
  producer.join();
}

TEST(BoundedQueue, ClearCountsWhatItForgets) {
  BoundedQueue<int> queue(4, WhenFull::kBlock);
  queue.Push(1);
  queue.Push(2);
  EXPECT_EQ(queue.Clear(), 2u);
  EXPECT_EQ(queue.NumDropped(), 2u);
  EXPECT_EQ(queue.TryPop(), std::nullopt);
}

TEST(BoundedQueue, HoldsItemsThatCanOnlyBeMoved) {
  BoundedQueue<std::unique_ptr<int>> queue(1, WhenFull::kBlock);
  queue.Push(std::make_unique<int>(5));
  EXPECT_EQ(**queue.Pop(), 5);
}

}  // namespace
}  // namespace rovio_sfm
