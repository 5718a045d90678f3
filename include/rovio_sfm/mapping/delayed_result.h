#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// When what was solved beside the flow comes back (design 4).
enum class ResultTiming {
  kFixed,      // replay: a fixed number of keyframes later, whatever the threads do meanwhile
  kWhenReady,  // live: nothing ever waits for it
};

// That number of keyframes: a function of the number of frames solved, so that the flow seldom has
// to wait.
inline int ResultDelay(size_t num_frames) { return 2 + static_cast<int>(num_frames / 40); }

// Somebody waits for a result: as long as this or a copy of it lives.
class Wait {
 public:
  // For the task, on any thread.
  std::function<bool()> IsGivenUp() const {
    return [life = std::weak_ptr<const bool>(life_)] { return life.expired(); };
  }

 private:
  std::shared_ptr<const bool> life_ = std::make_shared<const bool>(true);
};

// A result that is worked out beside the flow; it is given up where this ends without taking it.
template <typename Result>
class DelayedResult {
 public:
  DelayedResult(std::future<Result> result, size_t num_frames, ResultTiming timing, Wait wait = {})
      : wait_(std::move(wait)),
        result_(std::move(result)),
        num_left_(ResultDelay(num_frames)),
        timing_(timing) {}

  void CountKeyframe() { --num_left_; }
  bool IsReady() const {
    return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  bool IsDue() const { return timing_ == ResultTiming::kFixed ? num_left_ <= 0 : IsReady(); }
  // Waits for it where it is not there; that time counts as the stage "wait" (times may be null).
  Result Take(StageTimes* times) {
    if (IsReady()) return result_.get();
    const auto scope = MeasureStage(times, "wait");
    return result_.get();
  }

 private:
  Wait wait_;
  std::future<Result> result_;
  int num_left_;  // keyframes
  ResultTiming timing_;
};

}  // namespace rovio_sfm
