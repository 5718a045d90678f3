#include "rovio_sfm/util/executor.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace rovio_sfm {
namespace {

std::vector<int> Squares(int num_threads) {
  Executor executor(num_threads);
  std::vector<std::future<int>> futures;
  for (int i = 0; i < 200; ++i) futures.push_back(executor.Submit([i] { return i * i; }));
  std::vector<int> squares;
  for (auto& future : futures) squares.push_back(future.get());
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
  executor.Submit([&seen] { seen = std::this_thread::get_id(); });
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
    for (int i = 0; i < 100; ++i) executor.Submit([i, &order] { order.push_back(i); });
  }
  ASSERT_EQ(order.size(), 100u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(order[static_cast<size_t>(i)], i);
}

TEST(Executor, TheDestructorFinishesWhatIsQueued) {
  std::promise<void> release;
  std::future<int> last;
  {
    Executor executor(1);
    executor.Submit([gate = release.get_future().share()] { gate.wait(); });
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
  auto future = executor.Submit([value = 5]() mutable { return std::make_unique<int>(value); });
  EXPECT_EQ(*future.get(), 5);
}

}  // namespace
}  // namespace rovio_sfm
