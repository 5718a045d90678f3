#include "rovio_sfm/util/executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rovio_sfm {
namespace {

std::vector<int> Squares(int num_threads) {
  Executor executor(num_threads);
  TaskGroup<int> tasks(&executor);
  for (int i = 0; i < 200; ++i) tasks.Add([i] { return i * i; });
  std::vector<int> squares;
  while (tasks.NumPending() > 0) squares.push_back(tasks.TakeNext());
  return squares;
}

TEST(Executor, GivesTheSameResultsInTheCallersOrderWithAnyNumberOfThreads) {
  const std::vector<int> expected = Squares(0);
  ASSERT_EQ(expected.size(), 200u);
  EXPECT_EQ(expected[199], 199 * 199);
  EXPECT_EQ(Squares(1), expected);
  EXPECT_EQ(Squares(3), expected);
}

TEST(Executor, RunsAtOnceOnTheCallersThreadWithoutThreads) {
  Executor executor(0);
  std::thread::id seen;
  TaskGroup<void> tasks(&executor);
  tasks.Add([&seen] { seen = std::this_thread::get_id(); });
  EXPECT_EQ(seen, std::this_thread::get_id());
}

TEST(Executor, RunsBesideTheCallerWithThreads) {
  Executor executor(1);
  EXPECT_NE(executor.Submit([] { return std::this_thread::get_id(); }).get(),
            std::this_thread::get_id());
}

TEST(Executor, OneThreadKeepsTheOrderOfItsTasks) {
  std::vector<int> order;
  {
    Executor executor(1);
    TaskGroup<void> tasks(&executor);
    for (int i = 0; i < 100; ++i) tasks.Add([i, &order] { order.push_back(i); });
    while (tasks.NumPending() > 0) tasks.TakeNext();
  }
  ASSERT_EQ(order.size(), 100u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(order[static_cast<size_t>(i)], i);
}

TEST(Executor, TheDestructorFinishesWhatIsQueued) {
  std::promise<void> release;
  std::future<int> last;
  {
    Executor executor(1);
    executor.Submit([](const std::shared_future<void>& gate) { gate.wait(); },
                    release.get_future().share());
    last = executor.Submit([] { return 7; });
    release.set_value();
  }
  EXPECT_EQ(last.get(), 7);
}

TEST(Executor, HandsExceptionsToTheOneWhoAsks) {
  for (const int num_threads : {0, 1}) {
    Executor executor(num_threads);
    auto failed = executor.Submit([]() -> int { throw std::runtime_error("no"); });
    EXPECT_THROW(failed.get(), std::runtime_error);
    EXPECT_EQ(executor.Submit([] { return 1; }).get(), 1);
  }
}

TEST(Executor, MovesResultsThatCannotBeCopied) {
  Executor executor(1);
  auto future =
      executor.Submit([](std::unique_ptr<int> value) { return std::make_unique<int>(*value + 1); },
                      std::make_unique<int>(4));
  EXPECT_EQ(*future.get(), 5);
}

// What the tasks refer to goes when the exception leaves the scope; none may run after that.
TEST(TaskGroup, EndsAfterItsTasksWhereAnExceptionEndsTheScope) {
  for (const int num_threads : {0, 1, 3}) {
    Executor executor(num_threads);
    std::atomic<int> num_running{0};
    bool is_gone = false;
    std::atomic<int> num_late{0};
    try {
      TaskGroup<int> tasks(&executor);
      for (int i = 0; i < 100; ++i) {
        tasks.Add([&, i] {
          ++num_running;
          if (i == 0) throw std::runtime_error("no");
          if (is_gone) ++num_late;
          --num_running;
          return i;
        });
      }
      tasks.TakeNext();
      FAIL();
    } catch (const std::runtime_error&) {
      is_gone = true;
      EXPECT_EQ(num_running, 1);  // the one that threw
    }
    executor.Submit([] {}).wait();
    EXPECT_EQ(num_late, 0);
  }
}

TEST(TaskGroup, HandsOnResultsThatCannotBeCopied) {
  Executor executor(1);
  TaskGroup<std::unique_ptr<int>> tasks(&executor);
  tasks.Add([value = std::make_unique<int>(7)]() mutable { return std::move(value); });
  EXPECT_EQ(*tasks.TakeNext(), 7);
}

}  // namespace
}  // namespace rovio_sfm
