#pragma once

#include <functional>
#include <future>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

// Threads that run pure functions beside the caller, each thread its own tasks in turn. Results
// come back as futures and are consumed in the caller's order, so they never depend on the threads.
// With no threads a task runs at once, in Submit. The destructor finishes what is queued.
class Executor {
 public:
  explicit Executor(int num_threads) {
    for (int i = 0; i < num_threads; ++i) {
      workers_.push_back(std::make_unique<Worker<std::function<void()>>>(
          kCapacity, WhenFull::kBlock, [](std::function<void()> task) { task(); }));
    }
  }

  // Call from one thread only.
  template <typename Function>
  auto Submit(Function function) -> std::future<std::invoke_result_t<Function>> {
    using Result = std::invoke_result_t<Function>;
    auto task = std::make_shared<std::packaged_task<Result()>>(std::move(function));
    std::future<Result> future = task->get_future();
    if (workers_.empty()) {
      (*task)();
    } else {
      workers_[next_]->Push([task] { (*task)(); });
      next_ = (next_ + 1) % workers_.size();
    }
    return future;
  }

 private:
  static constexpr size_t kCapacity = 64;  // tasks per thread; Submit blocks when full

  std::vector<std::unique_ptr<Worker<std::function<void()>>>> workers_;
  size_t next_ = 0;
};

}  // namespace rovio_sfm
