#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// Sums the time that each stage of a pipeline takes, by an injected clock (nanoseconds, steady);
// the core itself reads no clock. A null clock measures nothing. Thread-safe.
class StageTimes {
 public:
  struct Total {
    int64_t count = 0;
    int64_t total_ns = 0;
  };

  // Measures from its birth to its death. The StageTimes must outlive it.
  class Scope {
   public:
    Scope(StageTimes* times, const char* stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    StageTimes* times_;
    const char* stage_;
    int64_t start_ns_ = 0;
  };

  explicit StageTimes(std::function<int64_t()> now_ns);

  Scope Measure(const char* stage) { return Scope(this, stage); }
  std::map<std::string, Total> totals() const;

 private:
  std::function<int64_t()> now_ns_;
  mutable Mutex mutex_;
  std::map<std::string, Total> totals_ GUARDED_BY(mutex_);
};

// Measures a stage where times may be null.
inline StageTimes::Scope MeasureStage(StageTimes* times, const char* stage) {
  return StageTimes::Scope(times, stage);
}

}  // namespace rovio_sfm
