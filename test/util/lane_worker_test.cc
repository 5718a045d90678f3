#include "rovio_sfm/util/lane_worker.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace rovio_sfm {
namespace {

constexpr size_t kFrames = 0, kMatches = 1;

TEST(LaneWorker, FloodOfMatchesPushesNoFrameOutWhileTheWorkerIsBusy) {
  std::promise<void> busy, free;
  std::vector<int> handled;
  LaneWorker<int> worker({{4, LaneFull::kDropOldest}, {8, LaneFull::kRefuse}}, [&](int item) {
    if (item == 0) {
      busy.set_value();
      free.get_future().wait();
    }
    handled.push_back(item);
  });
  worker.Push(kFrames, 0);
  busy.get_future().wait();
  for (int frame = 1; frame <= 3; ++frame) {
    EXPECT_TRUE(worker.Push(kFrames, frame));
    for (int i = 0; i < 50; ++i) worker.Push(kMatches, 100);
  }
  EXPECT_EQ(worker.NumQueued(kFrames), 3u);
  EXPECT_EQ(worker.NumQueued(), 11u);
  free.set_value();
  worker.Finish();
  EXPECT_EQ(worker.NumDropped(kFrames), 0u);
  EXPECT_EQ(worker.NumDropped(kMatches), 142u);
  ASSERT_EQ(handled.size(), 12u);
  EXPECT_EQ(handled[1], 1);
  EXPECT_EQ(handled[10], 2);
  EXPECT_EQ(handled[11], 3);
}

TEST(LaneWorker, StoppedItForgetsWhatIsQueued) {
  std::promise<void> busy, free;
  LaneWorker<int> worker({{4, LaneFull::kDropOldest}}, [&](int) {
    busy.set_value();
    free.get_future().wait();
  });
  worker.Push(kFrames, 0);
  busy.get_future().wait();
  worker.Push(kFrames, 1);
  worker.Push(kFrames, 2);
  auto stopped = std::async(std::launch::async, [&] { return worker.Stop(); });
  while (worker.NumQueued() > 0) std::this_thread::yield();
  free.set_value();
  EXPECT_EQ(stopped.get(), 2u);
  EXPECT_FALSE(worker.Push(kFrames, 3));
}

}  // namespace
}  // namespace rovio_sfm
