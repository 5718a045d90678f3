#include "rovio_sfm/ros/job_worker.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

constexpr size_t kFrames = 0, kCalls = 1;

std::vector<LaneOptions> Lanes() { return {{2, LaneFull::kDropOldest}, {1, LaneFull::kRefuse}}; }

void RunJob(const Job& job) { job(); }

TEST(RunAndWait, ReturnsWhenTheJobIsDone) {
  JobWorker worker(Lanes(), RunJob);
  int value = 0;
  EXPECT_TRUE(RunAndWait([&] { value = 7; }, kCalls, &worker));
  EXPECT_EQ(value, 7);
}

TEST(RunAndWait, SaysThatAClosedWorkerDidNothing) {
  JobWorker worker(Lanes(), RunJob);
  worker.Finish();
  EXPECT_FALSE(RunAndWait([] {}, kCalls, &worker));
}

TEST(RunAndWait, SaysSoAtOnceWhenTooManyCallsWait) {
  JobWorker worker(Lanes(), RunJob);
  std::promise<void> busy, free;
  worker.Push(kFrames, [&] {
    busy.set_value();
    free.get_future().wait();
  });
  busy.get_future().wait();
  bool has_first_run = false;
  worker.Push(kCalls, [&] { has_first_run = true; });
  EXPECT_FALSE(RunAndWait([] {}, kCalls, &worker));
  free.set_value();
  worker.Finish();
  EXPECT_TRUE(has_first_run);
}

TEST(RunAndWait, CallIsNotPushedOutByFrames) {
  JobWorker worker(Lanes(), RunJob);
  std::promise<void> busy, free;
  worker.Push(kFrames, [&] {
    busy.set_value();
    free.get_future().wait();
  });
  busy.get_future().wait();
  auto call = std::async(std::launch::async, [&] { return RunAndWait([] {}, kCalls, &worker); });
  while (worker.NumQueued(kCalls) == 0) std::this_thread::yield();
  for (int i = 0; i < 100; ++i) worker.Push(kFrames, [] {});
  free.set_value();
  EXPECT_TRUE(call.get());
  EXPECT_EQ(worker.NumDropped(kFrames), 98u);
}

}  // namespace
}  // namespace rovio_sfm
