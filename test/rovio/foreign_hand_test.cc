#include "rovio_sfm/rovio/foreign_hand.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

McuReport Turning() {
  McuReport mcu;
  mcu.wheels[0].ticks = mcu.wheels[1].ticks = 4;
  return mcu;
}

RobotReport WithResolution(int resolution) {
  RobotReport report;
  report.state = 0;
  report.camera = SomeSettings(CameraSettings{});
  report.camera.resolution = resolution;
  return report;
}

TEST(ForeignHand, SeesWheelsThatTurnWithoutACommand) {
  ForeignHand hand;
  hand.Look(Turning(), 0);  // what happened before this driver began
  EXPECT_EQ(hand.Reason(0), "");
  hand.NoteOwnMotion(1 * kSecond);
  hand.Look(Turning(), 3 * kSecond);
  EXPECT_EQ(hand.Reason(3 * kSecond), "");
  hand.Look(Turning(), 5 * kSecond);
  EXPECT_NE(hand.Reason(5 * kSecond).find("wheels"), std::string::npos);
  EXPECT_EQ(hand.Reason(70 * kSecond), "");
}

TEST(ForeignHand, LeavesARobotThatDrivesByItselfAlone) {
  ForeignHand hand;
  hand.Look(McuReport{}, 0);
  RobotReport homing = WithResolution(3);
  homing.state = 1;
  hand.Look(homing, 10 * kSecond);
  hand.Look(Turning(), 11 * kSecond);
  EXPECT_EQ(hand.Reason(11 * kSecond), "");
}

TEST(ForeignHand, SeesSettingsThatNobodyHereAskedFor) {
  ForeignHand hand;
  hand.Look(WithResolution(2), 0);
  hand.NoteOwnSettings(1 * kSecond);
  hand.Look(WithResolution(3), 2 * kSecond);
  EXPECT_EQ(hand.Reason(2 * kSecond), "");
  hand.Look(WithResolution(1), 20 * kSecond);
  EXPECT_NE(hand.Reason(20 * kSecond).find("resolution 1"), std::string::npos);
}

TEST(ForeignHand, AFieldThatIsNotReportedIsNoChange) {
  ForeignHand hand;
  RobotReport report = WithResolution(3);
  hand.Look(report, 0);
  report.camera.resolution.reset();
  hand.Look(report, 20 * kSecond);
  EXPECT_EQ(hand.Reason(20 * kSecond), "");
}

}  // namespace
}  // namespace rovio_sfm
