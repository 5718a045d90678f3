#pragma once

#include <chrono>
#include <type_traits>

#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {

// Below the 15 s after which roslaunch sends its second signal.
constexpr double kEndBudgetS = 12.0;

// Runs what ends a program, and gives its result. Where, after a signal, the budget is used up
// first, give_up ends the program without it, and does not return. Without a signal there is no
// budget.
template <typename Function, typename GiveUp>
auto EndInTime(const Function& end, const GiveUp& give_up, double budget_s = kEndBudgetS) {
  const std::chrono::milliseconds look_period(50);
  Executor executor(1);
  TaskGroup<std::invoke_result_t<Function>> ending(&executor);
  ending.Add([&end] { return end(); });
  while (!ending.IsReadyWithin(look_period)) {
    if (SecondsSinceStop().value_or(0.0) > budget_s) give_up();
  }
  return ending.TakeNext();
}

}  // namespace rovio_sfm
