#include "rovio_sfm/scene/stamp_order.h"

#include <gtest/gtest.h>

#include <limits>

namespace rovio_sfm {
namespace {

TEST(StampOrder, TellsARepeatedOrSwappedStampFromAJump) {
  EXPECT_EQ(OrderOf(11, 10), StampOrder::kLater);
  EXPECT_EQ(OrderOf(10, 10), StampOrder::kLate);
  EXPECT_EQ(OrderOf(10, 10 + kMaxLateNs), StampOrder::kLate);
  EXPECT_EQ(OrderOf(10, 11 + kMaxLateNs), StampOrder::kJumpedBack);
}

TEST(StampOrder, HoldsForAllNumbers) {
  constexpr int64_t kLowest = std::numeric_limits<int64_t>::min();
  constexpr int64_t kHighest = std::numeric_limits<int64_t>::max();
  EXPECT_EQ(OrderOf(kLowest, kHighest), StampOrder::kJumpedBack);
  EXPECT_EQ(OrderOf(kHighest, kLowest), StampOrder::kLater);
}

}  // namespace
}  // namespace rovio_sfm
