#include "rovio_sfm/util/lane_queue.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace rovio_sfm {
namespace {

constexpr size_t kDropping = 0, kRefusing = 1;

LaneQueue<std::string> TwoLanes() {
  return LaneQueue<std::string>({{2, LaneFull::kDropOldest}, {3, LaneFull::kRefuse, 10}});
}

TEST(LaneQueue, ItemsOfAllLanesComeOutInTheOrderTheyCameIn) {
  LaneQueue<std::string> queue = TwoLanes();
  queue.Push(kRefusing, "a");
  queue.Push(kDropping, "b");
  queue.Push(kRefusing, "c");
  queue.Close();
  EXPECT_EQ(queue.Pop(), "a");
  EXPECT_EQ(queue.Pop(), "b");
  EXPECT_EQ(queue.Pop(), "c");
  EXPECT_FALSE(queue.Pop());
}

TEST(LaneQueue, FloodInOneLanePushesNothingOutOfAnother) {
  LaneQueue<std::string> queue = TwoLanes();
  queue.Push(kDropping, "frame");
  queue.Push(kRefusing, "call");
  for (int i = 0; i < 100; ++i) queue.Push(kRefusing, "match");
  for (int i = 0; i < 100; ++i) queue.Push(kDropping, "frame " + std::to_string(i));
  EXPECT_EQ(queue.NumDropped(kRefusing), 98u);
  EXPECT_EQ(queue.NumDropped(kDropping), 99u);
  EXPECT_EQ(queue.Size(kRefusing), 3u);
  EXPECT_EQ(queue.Size(), 5u);
  EXPECT_EQ(queue.Pop(), "call");
}

TEST(LaneQueue, DroppingLaneKeepsTheNewestRefusingLaneTheOldest) {
  LaneQueue<std::string> queue = TwoLanes();
  for (const char* name : {"1", "2", "3", "4"}) {
    EXPECT_TRUE(queue.Push(kDropping, name));
    EXPECT_EQ(queue.Push(kRefusing, name), std::string(name) != "4");
  }
  queue.Close();
  EXPECT_EQ(queue.Pop(), "1");
  EXPECT_EQ(queue.Pop(), "2");
  EXPECT_EQ(queue.Pop(), "3");
  EXPECT_EQ(queue.Pop(), "3");
  EXPECT_EQ(queue.Pop(), "4");
}

TEST(LaneQueue, BytesFillALaneToo) {
  LaneQueue<std::string> queue = TwoLanes();
  EXPECT_TRUE(queue.Push(kRefusing, "large", 11));  // alone it fits
  EXPECT_FALSE(queue.Push(kRefusing, "small", 1));
  EXPECT_EQ(queue.Pop(), "large");
  EXPECT_TRUE(queue.Push(kRefusing, "small", 6));
  EXPECT_FALSE(queue.Push(kRefusing, "small", 6));
  EXPECT_TRUE(queue.Push(kRefusing, "small", 4));
}

TEST(LaneQueue, ClosedItTakesNothingInAndWakesWhoWaits) {
  LaneQueue<std::string> queue = TwoLanes();
  bool has_ended = false;
  std::thread waiting([&] { has_ended = !queue.Pop().has_value(); });
  queue.Close();
  waiting.join();
  EXPECT_TRUE(has_ended);
  EXPECT_FALSE(queue.Push(kDropping, "late"));
  EXPECT_EQ(queue.NumDropped(kDropping), 0u);
}

TEST(LaneQueue, ClearedItemsCountAsDropped) {
  LaneQueue<std::string> queue = TwoLanes();
  queue.Push(kDropping, "a");
  queue.Push(kRefusing, "b", 10);
  EXPECT_EQ(queue.Clear(), 2u);
  EXPECT_EQ(queue.NumDropped(kRefusing), 1u);
  EXPECT_TRUE(queue.Push(kRefusing, "c", 10));
}

}  // namespace
}  // namespace rovio_sfm
