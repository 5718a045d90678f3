#pragma once

#include <cstdint>

namespace rovio_sfm {

// How a stamp of a stream stands to the newest before it.
enum class StampOrder {
  kLater,
  kLate,       // repeated, or swapped with a newer one: what bears it is passed over
  kJumpedBack  // the clock or the bag began anew: so does what is made of the stream
};

constexpr int64_t kMaxLateNs = 1'000'000'000;  // later than that time has jumped back

// Stamps in ns; all of int64_t may come.
constexpr StampOrder OrderOf(int64_t stamp_ns, int64_t newest_ns) {
  if (stamp_ns > newest_ns) return StampOrder::kLater;
  const auto late_ns = static_cast<uint64_t>(newest_ns) - static_cast<uint64_t>(stamp_ns);
  return late_ns <= static_cast<uint64_t>(kMaxLateNs) ? StampOrder::kLate : StampOrder::kJumpedBack;
}

}  // namespace rovio_sfm
