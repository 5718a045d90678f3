#include "rovio_sfm/sim/http/robot_access.h"

#include <gtest/gtest.h>

#include "sim/http/fake_robot.h"

namespace rovio_sfm::sim {
namespace {

class RobotAccessTest : public testing::Test {
 protected:
  McuReading Read() {
    return access_.With([](RobotBackend& robot) { return robot.ReadMcu(); });
  }

  FakeRobot robot_;
  Guarded<Quirks> quirks_;
  int64_t now_ns_ = 1'000'000'000;
  RobotAccess access_{robot_, [this] { return now_ns_; }, quirks_};
};

TEST_F(RobotAccessTest, BringsTheRobotUpToTheClockFirst) {
  Read();
  now_ns_ = 1'500'000'000;
  Read();
  EXPECT_EQ(robot_.times_ns, (std::vector<int64_t>{1'000'000'000, 1'500'000'000}));
}

TEST_F(RobotAccessTest, TimeNeverRunsBack) {
  Read();
  now_ns_ = 0;
  Read();
  EXPECT_EQ(robot_.times_ns, (std::vector<int64_t>{1'000'000'000, 1'000'000'000}));
}

TEST_F(RobotAccessTest, OwnReadsOfTheRobotStealTicks) {
  std::string error;
  quirks_.With([&](Quirks& quirks) { return quirks.Set("lost_ticks", 10.0, 0, &error); });
  Read();
  robot_.TakeLog();
  now_ns_ = 1'050'000'000;
  robot_.mcu.left.ticks = 5;
  EXPECT_EQ(Read().left.ticks, 5);
  now_ns_ = 1'250'000'000;
  robot_.mcu.left.ticks = 7;
  EXPECT_EQ(Read().left.ticks, 0);
  EXPECT_EQ(robot_.times_ns.back(), 1'250'000'000);
  EXPECT_EQ(robot_.times_ns[robot_.times_ns.size() - 2], 1'200'000'000);
}

TEST_F(RobotAccessTest, CapturesAtTheClock) {
  const auto image = access_.Capture({});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->time_ns, 1'000'000'000);
}

}  // namespace
}  // namespace rovio_sfm::sim
