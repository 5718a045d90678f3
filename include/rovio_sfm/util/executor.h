#pragma once

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

template <typename Result>
class TaskGroup;

// What a task may be given for its own: a value, nothing that somebody else may take away.
template <typename Argument>
struct OwnsItsValue : std::negation<std::is_pointer<Argument>> {};
template <typename Argument>
struct OwnsItsValue<std::reference_wrapper<Argument>> : std::false_type {};

// Threads that run pure functions beside the caller, each thread its own tasks in turn. Results
// are consumed in the caller's order, so they never depend on the threads. With no threads a task
// runs at once, where it is handed over. The destructor finishes what is queued. A task either owns
// all that it works on (Submit), or belongs to a TaskGroup, which never ends before it.
class Executor {
 public:
  explicit Executor(int num_threads) {
    for (int i = 0; i < num_threads; ++i) {
      workers_.push_back(std::make_unique<Worker<std::function<void()>>>(
          kCapacity, WhenFull::kBlock, [](std::function<void()> task) { task(); }));
    }
  }

  // The function captures nothing; the arguments become the task's own. The future may be given up.
  // Call from one thread only.
  template <typename Function, typename... Arguments>
  auto Submit(Function function, Arguments&&... arguments)
      -> std::future<std::invoke_result_t<Function, std::decay_t<Arguments>&&...>> {
    static_assert(std::is_empty_v<Function>, "what captures goes to a TaskGroup");
    static_assert((OwnsItsValue<std::decay_t<Arguments>>::value && ...),
                  "what points goes to a TaskGroup");
    return Enqueue([function, owned = std::tuple<std::decay_t<Arguments>...>(
                                  std::forward<Arguments>(arguments)...)]() mutable {
      return std::apply(function, std::move(owned));
    });
  }

 private:
  template <typename Result>
  friend class TaskGroup;

  template <typename Function>
  auto Enqueue(Function function) -> std::future<std::invoke_result_t<Function>> {
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

  static constexpr size_t kCapacity = 64;  // tasks per thread; handing over blocks when full

  std::vector<std::unique_ptr<Worker<std::function<void()>>>> workers_;
  size_t next_ = 0;
};

// Tasks that work on what is not theirs. The destructor waits for those that run and forgets those
// that did not begin, so whatever was declared before the group outlives its tasks, also where an
// exception ends the scope. For one thread; the executor is borrowed.
template <typename Result>
class TaskGroup {
 public:
  explicit TaskGroup(Executor* executor) : executor_(executor) {}
  ~TaskGroup() { Abandon(); }
  TaskGroup(const TaskGroup&) = delete;
  TaskGroup& operator=(const TaskGroup&) = delete;

  // Refers only to what was declared before this group.
  template <typename Function>
  void Add(Function function) {
    results_.push_back(executor_->Enqueue(
        [function = std::move(function), abandoned = abandoned_]() mutable -> Taken {
          if (*abandoned) return Taken();
          return RunTask(&function);
        }));
  }

  size_t NumPending() const { return results_.size(); }

  // Whether the oldest task has ended within the time.
  bool IsReadyWithin(std::chrono::milliseconds time) const {
    return results_.front().wait_for(time) == std::future_status::ready;
  }

  // Waits for the oldest task. Its result, or what it threw.
  Result TakeNext() {
    std::future<Taken> oldest = std::move(results_.front());
    results_.pop_front();
    if constexpr (std::is_void_v<Result>) {
      oldest.get();
    } else {
      return std::move(*oldest.get());
    }
  }

 private:
  // Of an abandoned task: nothing.
  using Taken = std::conditional_t<std::is_void_v<Result>, std::monostate, std::optional<Result>>;

  template <typename Function>
  static Taken RunTask(Function* function) {
    if constexpr (std::is_void_v<Result>) {
      (*function)();
      return Taken();
    } else {
      return Taken((*function)());
    }
  }

  void Abandon() {
    *abandoned_ = true;
    for (const std::future<Taken>& result : results_) result.wait();
  }

  Executor* executor_;
  std::shared_ptr<std::atomic<bool>> abandoned_ = std::make_shared<std::atomic<bool>>(false);
  std::deque<std::future<Taken>> results_;  // oldest first
};

}  // namespace rovio_sfm
