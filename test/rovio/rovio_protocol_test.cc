#include "rovio_sfm/rovio/rovio_protocol.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

// Bodies of a real robot, byte by byte.
constexpr char kReport[] =
    "Cmd = nav\nresponses = 0|x=3718|y=3495|theta=0.863|room=0|ss=60\n"
    "|beacon=51|beacon_x=9941|next_room=-1|next_room_ss=0\n"
    "|state=0|ui_status=0|resistance=0|sm=15|pp=0|flags=0001\n"
    "|brightness=6|resolution=3|video_compression=2|frame_rate=30\n"
    "|privilege=0|user_check=1|speaker_volume=14|mic_volume=17\n"
    "|wifi_ss=212|show_time=0|ddns_state=0|email_state=0\n"
    "|battery=123|charging=0|head_position=202|ac_freq=2\n";
constexpr char kMcuReport[] = "Cmd = nav\nresponses = 0E0100000000000000000003CB744B\n";

TEST(ParseReport, ReadsTheReportOfARealRobot) {
  std::string error;
  const std::optional<RobotReport> report = ParseReport(kReport, &error);
  ASSERT_TRUE(report) << error;
  EXPECT_EQ(report->signal_strength, 60);
  EXPECT_EQ(report->home_saved, true);
  EXPECT_EQ(report->obstacle, false);
  EXPECT_EQ(report->is_login_required, true);
  EXPECT_EQ(report->odd_fields, "");
  EXPECT_EQ(report->camera.resolution, 3);
  EXPECT_EQ(report->camera.compression, 2);
  EXPECT_EQ(report->camera.frame_rate, 30);
  EXPECT_EQ(report->camera.brightness, 6);
  EXPECT_EQ(report->wifi_strength, 212);
  EXPECT_EQ(report->battery, 123);
  EXPECT_EQ(report->head_position, 202);
}

TEST(ParseReport, ReadsFlagsAsHexDigits) {
  std::string body = kReport, error;
  body.replace(body.find("flags=0001"), 10, "flags=0007");
  const std::optional<RobotReport> report = ParseReport(body, &error);
  ASSERT_TRUE(report) << error;
  EXPECT_EQ(report->obstacle, true);
  EXPECT_EQ(report->infrared_on, true);
  EXPECT_EQ(report->home_saved, true);
}

TEST(ParseReport, NamesEachFieldThatIsMissingOrOddAndReadsTheOthers) {
  std::string body = kReport, error;
  body.replace(body.find("battery=123"), 11, "battery=abc");
  body.erase(body.find("|wifi_ss=212"), 12);
  body.replace(body.find("frame_rate=30"), 13, "frame_rate=999");
  const std::optional<RobotReport> report = ParseReport(body, &error);
  ASSERT_TRUE(report) << error;
  EXPECT_EQ(report->odd_fields,
            "wifi_ss is missing, battery is no number, frame_rate is out of range");
  EXPECT_FALSE(report->wifi_strength || report->battery || report->camera.frame_rate);
  EXPECT_EQ(report->camera.resolution, 3);
  EXPECT_EQ(report->head_position, 202);
}

TEST(ParseReport, RefusesOtherRepliesAndCodes) {
  std::string error;
  EXPECT_FALSE(ParseReport("", &error));
  EXPECT_FALSE(ParseReport("Version = Mar 1 2010 $Revision: 5.03$\n", &error));
  EXPECT_FALSE(ParseReport("Cmd = other\nresponses = 0\n", &error));
  EXPECT_FALSE(ParseReport("Cmd = nav\nresponses = 2\n", &error));
  EXPECT_EQ(error, "robot is busy");
}

TEST(ParseMcuReport, ReadsTheReportOfARealRobotOnItsDock) {
  std::string error;
  const std::optional<McuReport> report = ParseMcuReport(kMcuReport, &error);
  ASSERT_TRUE(report) << error;
  for (const WheelTicks& wheel : report->wheels) EXPECT_EQ(wheel.ticks, 0);
  EXPECT_EQ(report->head_position, 0xCB);
  EXPECT_EQ(report->battery, 0x74);
  EXPECT_TRUE(report->is_on_dock && report->is_charge_complete && report->headlight_on);
  EXPECT_FALSE(report->is_charging || report->obstacle);
}

TEST(ParseMcuReport, ReadsTicksBigEndianInTheOrderLeftRightRear) {
  std::string error;
  const std::optional<McuReport> report = ParseMcuReport(
      "Cmd = nav\nresponses = 0E01020102050304000000030087"
      "4B\n",
      &error);
  ASSERT_TRUE(report) << error;
  EXPECT_EQ(report->wheels[0].direction, 0x02);
  EXPECT_EQ(report->wheels[0].ticks, 0x0102);
  EXPECT_EQ(report->wheels[1].direction, 0x05);
  EXPECT_EQ(report->wheels[1].ticks, 0x0304);
  EXPECT_EQ(report->wheels[2].ticks, 0);
}

TEST(ParseMcuReport, RefusesWrongLengthsDigitsAndFirstByte) {
  std::string error;
  for (const char* const responses :
       {"", "0E01", "0E0100000000000000000003CB744", "0", "0G0100000000000000000003CB744B",
        "0F0100000000000000000003CB744B", "0E0100000000000000000003CB744B00"}) {
    EXPECT_FALSE(ParseMcuReport(std::string("Cmd = nav\nresponses = ") + responses, &error))
        << responses;
  }
}

TEST(ParseNavCode, ReadsTheCodeWithOrWithoutData) {
  EXPECT_EQ(ParseNavCode("Cmd = nav\nresponses = 0\n"), 0);
  EXPECT_EQ(ParseNavCode("Cmd = nav\r\nresponses = 22 | x = 1\r\n"), 22);
  EXPECT_EQ(ParseNavCode(""), std::nullopt);
  EXPECT_EQ(ParseNavCode("Cmd = nav\nerror = action is needed\n"), std::nullopt);
  EXPECT_EQ(ParseNavCode("<html>404</html>"), std::nullopt);
}

TEST(Targets, AreThoseOfTheRobot) {
  EXPECT_EQ(ReportTarget(), "/rev.cgi?Cmd=nav&action=1");
  EXPECT_EQ(McuReportTarget(), "/rev.cgi?Cmd=nav&action=20");
  EXPECT_EQ(DriveTarget(DriveCode::kForwardLeft, 5), "/rev.cgi?Cmd=nav&action=18&drive=7&speed=5");
  EXPECT_EQ(DriveTarget(DriveCode::kStop, 5), "/rev.cgi?Cmd=nav&action=18&drive=0");
  EXPECT_EQ(HeadTarget(HeadPosition::kUp), "/rev.cgi?Cmd=nav&action=18&drive=11");
  EXPECT_EQ(HeadTarget(HeadPosition::kDown), "/rev.cgi?Cmd=nav&action=18&drive=12");
  EXPECT_EQ(HeadTarget(HeadPosition::kMiddle), "/rev.cgi?Cmd=nav&action=18&drive=13");
  EXPECT_EQ(StopMotionTarget(), "/rev.cgi?Cmd=nav&action=33");
  EXPECT_EQ(HeadlightTarget(true), "/rev.cgi?Cmd=nav&action=19&LIGHT=1");
  EXPECT_EQ(StillTarget(7), "/Jpeg/CamImg7.jpg");
  EXPECT_EQ(ResolutionTarget(3), "/ChangeResolution.cgi?ResType=3");
}

TEST(CameraSettings, NamesTheSettingThatIsOutOfRange) {
  std::string error;
  CameraSettings settings;
  EXPECT_TRUE(IsValid(settings, &error));
  settings.resolution = 4;
  EXPECT_FALSE(IsValid(settings, &error));
  EXPECT_EQ(error, "resolution = 4: expected 0 to 3");
}

TEST(Parsers, SurviveRandomDamage) {
  Rng rng(7);
  std::string error;
  for (int round = 0; round < 3000; ++round) {
    std::string report = kReport, mcu = kMcuReport;
    for (std::string* const body : {&report, &mcu}) {
      for (int change = 0; change < 4; ++change) {
        (*body)[rng.UniformInt(static_cast<uint32_t>(body->size()))] =
            static_cast<char>(rng.UniformInt(256));
      }
      ParseReport(*body, &error);
      ParseMcuReport(*body, &error);
      ParseNavCode(*body);
    }
  }
}

}  // namespace
}  // namespace rovio_sfm
