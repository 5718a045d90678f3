#include "rovio_sfm/util/worker.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace rovio_sfm {
namespace {

TEST(Worker, HandlesEveryItemInOrderBeforeItFinishes) {
  std::vector<int> handled;
  Worker<int> worker(4, WhenFull::kBlock, [&handled](int item) { handled.push_back(item); });
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(worker.Push(i));
  worker.Finish();
  ASSERT_EQ(handled.size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(handled[static_cast<size_t>(i)], i);
}

TEST(Worker, TheDestructorFinishesTheQueue) {
  int sum = 0;
  {
    Worker<int> worker(8, WhenFull::kBlock, [&sum](int item) { sum += item; });
    for (int i = 1; i <= 4; ++i) worker.Push(i);
  }
  EXPECT_EQ(sum, 10);
}

TEST(Worker, RefusesItemsAfterFinish) {
  Worker<int> worker(1, WhenFull::kBlock, [](int) {});
  worker.Finish();
  EXPECT_FALSE(worker.Push(1));
}

TEST(Worker, DropsTheOldestWhileItIsBusy) {
  std::promise<void> started, release;
  std::vector<int> handled;
  Worker<int> worker(1, WhenFull::kDropOldest, [&](int item) {
    if (item == 0) {
      started.set_value();
      release.get_future().wait();
    }
    handled.push_back(item);
  });
  worker.Push(0);
  started.get_future().wait();
  for (int i = 1; i <= 3; ++i) worker.Push(i);
  EXPECT_EQ(worker.NumQueued(), 1u);
  release.set_value();
  worker.Finish();
  EXPECT_EQ(handled, (std::vector<int>{0, 3}));
  EXPECT_EQ(worker.NumDropped(), 2u);
}

TEST(Worker, StopForgetsWhatIsQueuedAndSaysHowMuch) {
  std::promise<void> started, release;
  Worker<int> worker(4, WhenFull::kBlock, [&](int item) {
    if (item == 0) {
      started.set_value();
      release.get_future().wait();
    }
  });
  worker.Push(0);
  started.get_future().wait();
  worker.Push(1);
  worker.Push(2);
  std::thread stopper([&worker] { EXPECT_EQ(worker.Stop(), 2u); });
  while (worker.NumQueued() > 0) std::this_thread::yield();
  release.set_value();
  stopper.join();
}

}  // namespace
}  // namespace rovio_sfm
