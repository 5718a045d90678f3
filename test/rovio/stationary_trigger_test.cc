#include "rovio_sfm/rovio/stationary_trigger.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(StationaryTrigger, TakesOneImagePerStopAfterTheRest) {
  StationaryTrigger trigger({300});
  trigger.Note(true, 1000);
  EXPECT_FALSE(trigger.Accept(1100));
  trigger.Note(false, 1200);
  EXPECT_FALSE(trigger.Accept(1499));
  EXPECT_TRUE(trigger.WantsImage(1500));
  EXPECT_TRUE(trigger.Accept(1500));
  trigger.Note(false, 1600);
  EXPECT_FALSE(trigger.Accept(9000));
  trigger.Note(true, 10000);
  trigger.Note(false, 11000);
  EXPECT_TRUE(trigger.Accept(11300));
}

TEST(StationaryTrigger, TakesAnImageBeforeTheFirstMotion) {
  StationaryTrigger trigger({300});
  EXPECT_FALSE(trigger.WantsImage(5000));  // nothing is known of the wheels yet
  trigger.Note(false, 5000);
  EXPECT_FALSE(trigger.Accept(5299));
  EXPECT_TRUE(trigger.Accept(5300));
}

TEST(StationaryTrigger, MotionDuringTheRestBeginsItAnew) {
  StationaryTrigger trigger({300});
  trigger.Note(false, 0);
  trigger.Note(true, 200);
  trigger.Note(false, 250);
  EXPECT_FALSE(trigger.Accept(400));
  EXPECT_TRUE(trigger.Accept(550));
}

}  // namespace
}  // namespace rovio_sfm
