#include "rovio_sfm/sim/robot/omni_drive.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

constexpr int64_t kSecond_ns = 1'000'000'000;

OmniDriveOptions WithoutSlip() {
  OmniDriveOptions options;
  options.slip.forward_gain_spread = 0.0;
  options.slip.min_side_loss = options.slip.max_side_loss = 0.0;
  options.slip.heading_walk_rad_per_sqrt_m = options.slip.lost_tick_share = 0.0;
  return options;
}

DriveCommand Command(int drive, int speed, int64_t hold_ns) {
  DriveCommand command;
  command.drive = drive;
  command.speed = speed;
  command.hold_ns = hold_ns;
  return command;
}

TEST(OmniDrive, StopsWhenTheCommandExpires) {
  OmniDrive drive({}, WithoutSlip(), {});
  drive.AdvanceTo(0);
  drive.Drive(Command(1, 1, kSecond_ns));
  drive.AdvanceTo(2 * kSecond_ns);
  const double x_m = drive.pose().x_m;
  EXPECT_NEAR(x_m, 0.30, 0.01);
  drive.AdvanceTo(5 * kSecond_ns);
  EXPECT_DOUBLE_EQ(drive.pose().x_m, x_m);
}

TEST(OmniDrive, DoesNotDependOnHowOftenSomebodyLooks) {
  OmniDrive once({}, {}, {}), often({}, {}, {});
  for (OmniDrive* drive : {&once, &often}) {
    drive->AdvanceTo(0);
    drive->Drive(Command(7, 3, kSecond_ns));
  }
  for (int64_t t = 0; t <= 2 * kSecond_ns; t += 3'333'333) often.AdvanceTo(t);
  often.AdvanceTo(2 * kSecond_ns);
  once.AdvanceTo(2 * kSecond_ns);
  EXPECT_EQ(once.pose().x_m, often.pose().x_m);
  EXPECT_EQ(once.pose().yaw_rad, often.pose().yaw_rad);
}

TEST(OmniDrive, TurnsByItsSteps) {
  OmniDrive drive({}, WithoutSlip(), {});
  drive.AdvanceTo(0);
  DriveCommand command = Command(17, 2, 0);
  command.angle_steps = 7;
  drive.Drive(command);
  drive.AdvanceTo(6 * kSecond_ns);
  EXPECT_NEAR(drive.pose().yaw_rad, M_PI / 2, 0.16);  // the lag lets it run on a little
}

TEST(OmniDrive, SpinsForEverWhenTold) {
  OmniDrive drive({}, WithoutSlip(), {});
  drive.AdvanceTo(0);
  drive.Drive(Command(18, 5, kHoldForever));
  drive.AdvanceTo(20 * kSecond_ns);
  EXPECT_LT(drive.pose().yaw_rad, -15.0);
  drive.Stop();
  drive.AdvanceTo(21 * kSecond_ns);
  const double yaw_rad = drive.pose().yaw_rad;
  drive.AdvanceTo(22 * kSecond_ns);
  EXPECT_DOUBLE_EQ(drive.pose().yaw_rad, yaw_rad);
}

TEST(OmniDrive, CountsTicksAndTheirSense) {
  OmniDrive drive({}, WithoutSlip(), {});
  drive.AdvanceTo(0);
  drive.Drive(Command(2, 1, kSecond_ns));
  drive.AdvanceTo(2 * kSecond_ns);
  const std::array<WheelReading, 3> ticks = drive.TakeTicks();
  EXPECT_EQ(ticks[kLeftWheel].direction, 0x02);
  EXPECT_NEAR(ticks[kLeftWheel].ticks, 0.3 * 0.866 * 465, 5);
  EXPECT_EQ(ticks[kRearWheel].ticks, 0);
  EXPECT_EQ(drive.TakeTicks()[kLeftWheel].ticks, 0);
}

TEST(OmniDrive, WheelsTurnButTheBodyStaysAtAWall) {
  OmniDrive drive({}, WithoutSlip(), [](double x_m, double) { return x_m < 0.1; });
  drive.AdvanceTo(0);
  drive.Drive(Command(1, 1, kSecond_ns));
  drive.AdvanceTo(2 * kSecond_ns);
  EXPECT_LT(drive.pose().x_m, 0.1);
  EXPECT_GT(drive.TakeTicks()[kLeftWheel].ticks, 90);
}

TEST(RatesOfDrive, GoesTheWaysOfTheTable) {
  EXPECT_GT(RatesOfDrive(1, 1).forward_m_per_s, RatesOfDrive(1, 10).forward_m_per_s);
  EXPECT_GT(RatesOfDrive(3, 5).left_m_per_s, 0.0);
  EXPECT_LT(RatesOfDrive(8, 5).left_m_per_s, 0.0);
  EXPECT_LT(RatesOfDrive(10, 5).forward_m_per_s, 0.0);
  EXPECT_GT(RatesOfDrive(5, 5).turn_rad_per_s, 0.0);
}

}  // namespace
}  // namespace rovio_sfm::sim
