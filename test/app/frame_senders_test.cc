#include "rovio_sfm/app/frame_senders.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

DriveId DriveOf(uint32_t nonce) { return {"rovio1", 100, nonce}; }

FrameOrigin From(const std::string& sender, double arrived_s, bool is_only_sender = false) {
  return {sender, is_only_sender, arrived_s};
}

TEST(FrameSenders, RefusesAnotherDriveOfAnotherSenderAndKeepsTheOneThatRuns) {
  FrameSenders senders;
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/rovio1/frontend", 0.0)));
  const auto refusal = senders.RefusalOf(DriveOf(2), From("/stray", 1.0));
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->find("/stray"), std::string::npos) << *refusal;
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/rovio1/frontend", 2.0)));
  EXPECT_EQ(senders.num_refused(), 1u);
}

TEST(FrameSenders, BeginsASendersOwnNextDriveAtOnce) {
  FrameSenders senders;
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/rovio1/frontend", 0.0)));
  EXPECT_FALSE(senders.RefusalOf(DriveOf(2), From("/rovio1/frontend", 0.1)));
  EXPECT_TRUE(senders.RefusalOf(DriveOf(1), From("/stray", 0.2)));
}

TEST(FrameSenders, TakesANewSenderWhenTheOldOneIsSilentOrGone) {
  FrameSenders senders;
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/a", 0.0)));
  EXPECT_TRUE(senders.RefusalOf(DriveOf(2), From("/b", 4.9)));
  EXPECT_FALSE(senders.RefusalOf(DriveOf(2), From("/b", 5.1)));
  EXPECT_FALSE(senders.RefusalOf(DriveOf(3), From("/c", 5.2, true)));
}

TEST(FrameSenders, KnowsRobotsApartAndADriveByEveryWay) {
  FrameSenders senders;
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/a", 0.0)));
  EXPECT_FALSE(senders.RefusalOf({"rovio2", 100, 7}, From("/b", 0.0)));
  EXPECT_FALSE(senders.RefusalOf(DriveOf(1), From("/relay", 0.1)));
  EXPECT_TRUE(senders.RefusalOf(DriveOf(2), From("/relay", 0.2)));
}

}  // namespace
}  // namespace rovio_sfm
