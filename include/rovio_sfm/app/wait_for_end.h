#pragma once

#include <chrono>
#include <future>

#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {

// Below the 15 s after which roslaunch sends its second signal.
constexpr double kEndBudgetS = 12.0;

// Waits for what ends a program. False where, after a signal, the budget was used up first: the
// caller then ends without it. Without a signal there is no budget.
template <typename Result>
bool EndsInTime(const std::shared_future<Result>& end, double budget_s = kEndBudgetS) {
  const std::chrono::milliseconds look_period(50);
  while (end.wait_for(look_period) != std::future_status::ready) {
    if (SecondsSinceStop().value_or(0.0) > budget_s) return false;
  }
  return true;
}

}  // namespace rovio_sfm
