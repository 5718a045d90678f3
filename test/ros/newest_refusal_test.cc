#include "rovio_sfm/ros/newest_refusal.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(NewestRefusal, NothingWasRefusedYet) {
  const NewestRefusal refusal;
  EXPECT_EQ(refusal.Reason(), "");
  EXPECT_EQ(refusal.RecentReason(1.0), "");
  EXPECT_EQ(refusal.Count(), 0u);
}

TEST(NewestRefusal, TheNewestCounts) {
  NewestRefusal refusal;
  refusal.Note("too large", 100.0);
  refusal.Note("too small", 101.0);
  EXPECT_EQ(refusal.Reason(), "too small");
  EXPECT_EQ(refusal.Count(), 2u);
}

TEST(NewestRefusal, IsNewsForHalfAMinute) {
  NewestRefusal refusal;
  refusal.Note("too large", 100.0);
  EXPECT_EQ(refusal.RecentReason(129.0), "too large");
  EXPECT_EQ(refusal.RecentReason(131.0), "");
  EXPECT_EQ(refusal.Reason(), "too large");
}

}  // namespace
}  // namespace rovio_sfm
