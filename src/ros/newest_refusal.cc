#include "rovio_sfm/ros/newest_refusal.h"

namespace rovio_sfm {
namespace {

constexpr double kNewsS = 30.0;

}  // namespace

void NewestRefusal::Note(const std::string& reason, double now_s) {
  MutexLock lock(mutex_);
  reason_ = reason;
  noted_s_ = now_s;
  ++count_;
}

std::string NewestRefusal::Reason() const {
  MutexLock lock(mutex_);
  return reason_;
}

std::string NewestRefusal::RecentReason(double now_s) const {
  MutexLock lock(mutex_);
  return now_s - noted_s_ < kNewsS ? reason_ : "";
}

uint64_t NewestRefusal::Count() const {
  MutexLock lock(mutex_);
  return count_;
}

}  // namespace rovio_sfm
