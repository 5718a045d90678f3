#include "rovio_sfm/sim/http/drive_action.h"

#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

NavResponse Drive(FaceFixture& face, const std::string& query) {
  return RunDriveAction(Parameters::Parse(query), face.context);
}

NavResponse Switch(FaceFixture& face, const std::string& query) {
  return RunSwitchAction(Parameters::Parse(query), face.context);
}

TEST(RunDriveAction, PassesGoodCommandsOn) {
  FaceFixture face;
  EXPECT_EQ(Drive(face, "drive=1&speed=5"), NavResponse::kSuccess);
  EXPECT_EQ(Drive(face, "drive=10&speed=10"), NavResponse::kSuccess);
  EXPECT_EQ(Drive(face, "drive=17&speed=1&angle=3"), NavResponse::kSuccess);
  EXPECT_EQ(Drive(face, "drive=18&speed=1"), NavResponse::kSuccess);
  EXPECT_EQ(face.robot.TakeLog(),
            "drive 1 speed 5, drive 10 speed 10, drive 17 speed 1 steps 3, drive 18 speed 1");
}

TEST(RunDriveAction, MovesTheHeadAndStopsWithoutASpeed) {
  FaceFixture face;
  for (const char* drive : {"11", "12", "13", "0"}) {
    EXPECT_EQ(Drive(face, std::string("drive=") + drive), NavResponse::kSuccess);
  }
  EXPECT_EQ(face.robot.TakeLog(), "head up, head down, head middle, stop");
}

TEST(RunDriveAction, RefusesWhatIsMissingOrOutOfRange) {
  FaceFixture face;
  EXPECT_EQ(Drive(face, "speed=1"), NavResponse::kParameterMissing);
  EXPECT_EQ(Drive(face, "drive=1"), NavResponse::kParameterMissing);
  for (const char* bad : {"drive=14&speed=1", "drive=-1&speed=1", "drive=x&speed=1",
                          "drive=1&speed=0", "drive=1&speed=11", "drive=1&speed=",
                          "drive=17&speed=1&angle=256", "drive=17&speed=1&angle=-1"}) {
    EXPECT_EQ(Drive(face, bad), NavResponse::kOutOfRange) << bad;
  }
  EXPECT_EQ(face.robot.TakeLog(), "");
}

TEST(RunDriveAction, BusyRobotRefusesMotionAndStillStops) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("busy", 1));
  EXPECT_EQ(Drive(face, "drive=1&speed=1"), NavResponse::kBusy);
  EXPECT_EQ(Drive(face, "drive=0"), NavResponse::kSuccess);
}

TEST(RunDriveAction, QuirkMakesATurnEndless) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("spin_forever", 2));
  Drive(face, "drive=17&speed=1&angle=1");
  Drive(face, "drive=1&speed=1");
  Drive(face, "drive=18&speed=1&angle=1");
  EXPECT_EQ(face.robot.TakeLog(),
            "drive 17 speed 1 steps 1, drive 1 speed 1, drive 18 speed 1 steps 1 for ever");
}

TEST(RunSwitchAction, SwitchesEitherOrBoth) {
  FaceFixture face;
  EXPECT_EQ(Switch(face, "LIGHT=1"), NavResponse::kSuccess);
  EXPECT_EQ(Switch(face, "IR=0&LIGHT=0"), NavResponse::kSuccess);
  EXPECT_EQ(Switch(face, ""), NavResponse::kParameterMissing);
  EXPECT_EQ(Switch(face, "IR=2"), NavResponse::kOutOfRange);
  EXPECT_EQ(face.robot.TakeLog(), "light on, IR off, light off");
}

}  // namespace
}  // namespace rovio_sfm::sim
