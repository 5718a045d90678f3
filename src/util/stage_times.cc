#include "rovio_sfm/util/stage_times.h"

#include <utility>

namespace rovio_sfm {

StageTimes::StageTimes(std::function<int64_t()> now_ns) : now_ns_(std::move(now_ns)) {}

std::map<std::string, StageTimes::Total> StageTimes::totals() const {
  const MutexLock lock(mutex_);
  return totals_;
}

StageTimes::Scope::Scope(StageTimes* times, const char* stage)
    : times_(times != nullptr && times->now_ns_ ? times : nullptr), stage_(stage) {
  if (times_ != nullptr) start_ns_ = times_->now_ns_();
}

StageTimes::Scope::~Scope() {
  if (times_ == nullptr) return;
  const int64_t elapsed_ns = times_->now_ns_() - start_ns_;
  const MutexLock lock(times_->mutex_);
  Total& total = times_->totals_[stage_];
  ++total.count;
  total.total_ns += elapsed_ns;
}

}  // namespace rovio_sfm
