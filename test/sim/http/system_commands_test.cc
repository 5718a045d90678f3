#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

TEST(SystemCommands, AnswerInTheRobotsShapes) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/GetStatus.cgi").size(), 9u + 96u + 1u);
  EXPECT_EQ(face.Ask("/GetStatus.cgi").substr(0, 11), "Status = 01");
  EXPECT_EQ(face.Ask("/GetVer.cgi"), "Version = Mar 16 2010 13:25:24 $Revision: 5.3705$\n");
  EXPECT_EQ(face.Ask("/GetMac.cgi"), "MAC = 00:01:36:00:00:01\n");
  EXPECT_EQ(face.Ask("/GetHttp.cgi"), "Port0 = 80\nPort1 = 0\n");
  EXPECT_EQ(face.Ask("/GetTime.cgi").substr(0, 21), "Sec1970 = 1262304000\n");
}

TEST(SystemCommands, RebootSendsTheRobotAway) {
  FaceFixture face;
  const RoutedReply routed = face.Route("/Reboot.cgi");
  EXPECT_EQ(routed.response.body, "Return = OK\n");
  EXPECT_EQ(routed.away, std::chrono::seconds(30));
  face.caller.privilege = Privilege::kUser;
  EXPECT_EQ(face.Status("/Reboot.cgi"), 401);
}

TEST(SystemCommands, FactoryDefaultForgetsUsersAndSettings) {
  FaceFixture face;
  face.Ask("/ChangeResolution.cgi?ResType=3");
  face.Ask("/SetUser.cgi?User=guest&Pass=x");
  EXPECT_TRUE(face.Route("/SetFactoryDefault.cgi").away.has_value());
  EXPECT_EQ(face.Ask("/GetUser.cgi"), "Name = admin\n");
  EXPECT_EQ(face.context.settings.Copy().resolution, 2);
}

TEST(SystemCommands, RawMcuPacketsAreCheckedAndAnswered) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/mcu?parameters=114D4D00010053485254000100010B000000"),
            "responses = 0E0100000000000000000003CB7E00\n");
  for (const char* bad : {"", "zz", "114D4D", "114", "%00%00"}) {
    EXPECT_EQ(face.Ask(std::string("/mcu?parameters=") + bad), "error = parameters\n") << bad;
  }
}

TEST(SystemCommands, DebugReadsAndWritesTheSensorsRegisters) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/debug.cgi?action=read_i2c&address=0x13"), "read_i2c = 00000013=000000f4\n");
  EXPECT_EQ(face.Ask("/debug.cgi?action=write_i2c&address=0x3b&value=0x0a"),
            "write_i2c = 0000003b=0000000a\n");
  EXPECT_EQ(face.Ask("/debug.cgi?action=read_i2c&address=0x3b"), "read_i2c = 0000003b=0000000a\n");
  EXPECT_EQ(face.Ask("/debug.cgi?action=read_i2c&address=0x100"), "error = address\n");
  EXPECT_EQ(face.Ask("/debug.cgi?action=write_i2c&address=0x13"), "error = value\n");
  EXPECT_EQ(face.Ask("/debug.cgi?action=melt"), "error = action\n");
  face.caller.privilege = Privilege::kUser;
  EXPECT_EQ(face.Status("/debug.cgi?action=read_i2c&address=0x13"), 401);
}

}  // namespace
}  // namespace rovio_sfm::sim
