#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

std::string Nav(FaceFixture& face, const std::string& parameters) {
  return face.Ask("/rev.cgi?Cmd=nav&" + parameters);
}

TEST(NavCommand, ReadingTheMcuClearsItsCounters) {
  FaceFixture face;
  face.robot.mcu.left = {0x05, 300};
  EXPECT_EQ(Nav(face, "action=20"), "Cmd = nav\nresponses = 0E0105012C00000000000003CB7E00\n");
  EXPECT_EQ(Nav(face, "action=20"), "Cmd = nav\nresponses = 0E0100000000000000000003CB7E00\n");
}

TEST(NavCommand, OtherReportsDoNotClearThem) {
  FaceFixture face;
  face.robot.mcu.left.ticks = 300;
  Nav(face, "action=1");
  EXPECT_EQ(face.robot.TakeLog(), "");
}

TEST(NavCommand, StateHasBlanksRoundTheBar) {
  FaceFixture face;
  face.robot.nav.state = 2;
  EXPECT_EQ(Nav(face, "action=22"), "Cmd = nav\nresponses = 0 | state=2\n");
}

TEST(NavCommand, StopButtonStopsThenResets) {
  FaceFixture face;
  EXPECT_EQ(Nav(face, "action=33"), "Cmd = nav\nresponses = 0\n");
  EXPECT_EQ(Nav(face, "action=17"), "Cmd = nav\nresponses = 0\n");
  EXPECT_EQ(face.robot.TakeLog(), "stop, abort");
}

TEST(NavCommand, AnswersCodesForTheRest) {
  FaceFixture face;
  EXPECT_EQ(Nav(face, "action=99"), "Cmd = nav\nresponses = 4\n");
  EXPECT_EQ(Nav(face, "action=x"), "Cmd = nav\nresponses = 4\n");
  EXPECT_EQ(Nav(face, "action=12"), "Cmd = nav\nresponses = 3\n");
  EXPECT_EQ(Nav(face, "action=25"), "Cmd = nav\nresponses = 0 | version = 5.13\n");
  EXPECT_EQ(Nav(face, "drive=1"), "Cmd = nav\nerror = action parameter is required\n");
}

TEST(NavCommand, QuirksCutReportsAndCrossReplies) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("short_mcu", 1));
  EXPECT_EQ(Nav(face, "action=20"), "Cmd = nav\nresponses = 0E0100000000000\n");
  ASSERT_TRUE(face.SetQuirk("battery", 100));
  ASSERT_TRUE(face.SetQuirk("short_mcu", 0));
  EXPECT_EQ(Nav(face, "action=20"), "Cmd = nav\nresponses = 0E0100000000000000000003CB6400\n");
  ASSERT_TRUE(face.SetQuirk("cross_replies", 1));
  EXPECT_EQ(Nav(face, "action=20"), "Cmd = nav\nresponses = 0 | version = 5.13\n");
}

TEST(NavCommand, SlowReplyEndsWithTheServer) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("slow_nav", 3600));
  face.context.stop.Request();
  EXPECT_EQ(Nav(face, "action=17"), "Cmd = nav\nresponses = 0\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
