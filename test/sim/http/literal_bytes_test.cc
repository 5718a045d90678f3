// Whole replies, byte by byte, as rovio-http.md says the robot sends them.
#include <gtest/gtest.h>

#include "rovio_sfm/sim/http/rovio_http_server.h"
#include "sim/http/fake_robot.h"
#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

const char kDateAndServer[] = "Date: Fri, 01 Jan 2010 00:00:00 GMT\r\nServer: WYM/1.0\r\n";
const char kNoCache[] =
    "Pragma: no-cache\r\nCache-Control: no-cache\r\nExpires: 01 Jan 1970 00:00:00 GMT\r\n";

class LiteralBytes : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    ASSERT_TRUE(server_.Start(&error)) << error;
  }
  std::string Get(const std::string& target, const std::string& headers = "") {
    return Exchange(server_.port(),
                    "GET " + target + " HTTP/1.1\r\nHost: x\r\n" + headers + "\r\n");
  }
  void SetQuirk(const std::string& name, double value) {
    std::string error;
    ASSERT_TRUE(server_.SetQuirk(name, value, &error)) << error;
  }

  FakeRobot robot_;
  RovioHttpServer server_{RovioHttpServerOptions(), robot_,
                          [] { return int64_t{1'262'304'000'000'000'000}; }};
};

TEST_F(LiteralBytes, NavReplyHasHttp10StatusLineAndTheRobotsHeaders) {
  EXPECT_EQ(Get("/rev.cgi?Cmd=nav&action=18&drive=1&speed=5"),
            std::string("HTTP/1.0 200 OK\r\n") + kDateAndServer + "Connection: close\r\n" +
                kNoCache +
                "Content-Type: text/plain\r\nContent-Length: 24\r\n\r\n"
                "Cmd = nav\nresponses = 0\n");
}

TEST_F(LiteralBytes, GetReportEqualsTheRecordedOne) {
  robot_.nav = {3718, 3495, 0.863, 0, 60, 51, 9941, -1, 0, 0, true};
  robot_.mcu.head_position = 202;
  robot_.mcu.battery = 123;
  for (const char* setting :
       {"ChangeResolution.cgi?ResType=3", "ChangeCompressRatio.cgi?Ratio=2",
        "ChangeSpeakerVolume.cgi?SpeakerVolume=14", "ChangeMicVolume.cgi?MicVolume=17",
        "SetCamera.cgi?Frequency=60", "SetUserCheck.cgi?Check=true"}) {
    EXPECT_EQ(BodyOf(Get(std::string("/") + setting)), "");
  }
  EXPECT_EQ(BodyOf(Get("/rev.cgi?Cmd=nav&action=1", "Authorization: Basic YWRtaW46YWRtaW4=\r\n")),
            "Cmd = nav\n"
            "responses = 0|x=3718|y=3495|theta=0.863|room=0|ss=60\n"
            "|beacon=51|beacon_x=9941|next_room=-1|next_room_ss=0\n"
            "|state=0|ui_status=0|resistance=0|sm=15|pp=0|flags=0001\n"
            "|brightness=6|resolution=3|video_compression=2|frame_rate=30\n"
            "|privilege=0|user_check=1|speaker_volume=14|mic_volume=17\n"
            "|wifi_ss=212|show_time=0|ddns_state=0|email_state=0\n"
            "|battery=123|charging=0|head_position=202|ac_freq=2\n");
}

TEST_F(LiteralBytes, McuReportEqualsTheRecordedOne) {
  robot_.mcu.head_position = 0xCB;
  robot_.mcu.battery = 0x74;
  robot_.mcu.headlight = robot_.mcu.infrared = true;
  robot_.mcu.charge_complete = robot_.mcu.on_dock = true;
  EXPECT_EQ(BodyOf(Get("/rev.cgi?Cmd=nav&action=20")),
            "Cmd = nav\nresponses = 0E0100000000000000000003CB744B\n");
}

TEST_F(LiteralBytes, RefusedLoginNamesTheRealmOfTheLevel) {
  SetQuirk("require_login", 1);
  const std::string page =
      "Content-Type: text/html\r\nContent-Length: 98\r\n\r\n"
      "<HTML><HEAD><TITLE>401 Unauthorized</TITLE></HEAD>\n"
      "<BODY><H1>401 Unauthorized</H1>\n</BODY></HTML>\n";
  EXPECT_EQ(Get("/GetStatus.cgi"),
            std::string("HTTP/1.0 401 Unauthorized\r\n") + kDateAndServer +
                "Connection: close\r\nWWW-Authenticate: Basic realm=\"Rovio\"\r\n" + page);
  EXPECT_EQ(Get("/GetUser.cgi"),
            std::string("HTTP/1.0 401 Unauthorized\r\n") + kDateAndServer +
                "Connection: close\r\n"
                "WWW-Authenticate: Basic realm=\"Administrator for Rovio\"\r\n" +
                page);
}

TEST_F(LiteralBytes, StillIsANewPictureWithItsLength) {
  RawClient client(server_.port());
  client.Send("GET /Jpeg/CamImg[0000].jpg HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_.CaptureForNextClient());
  const std::string picture = FakeRobot::PictureText(1);
  EXPECT_EQ(client.ReadToEnd(), std::string("HTTP/1.0 200 OK\r\n") + kDateAndServer +
                                    "Connection: close\r\n" + kNoCache +
                                    "Content-Type: image/jpeg\r\nContent-Length: " +
                                    std::to_string(picture.size()) + "\r\n\r\n" + picture);
}

TEST_F(LiteralBytes, StreamHasNoPartLengthAndNoLineEndBeforeABoundary) {
  RawClient client(server_.port());
  client.Send("GET /GetData.cgi HTTP/1.1\r\nConnection: Keep-Alive\r\n\r\n");
  ASSERT_TRUE(server_.CaptureForNextClient());
  const std::string head =
      std::string("HTTP/1.0 200 OK\r\n") + kDateAndServer + "Connection: close\r\n" + kNoCache +
      "Content-Type: multipart/x-mixed-replace;boundary=WINBONDBOUDARY\r\n\r\n";
  const std::string part = "--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\n\r\n";
  EXPECT_EQ(client.ReadUntil("\xFF\xD9"), head + part + FakeRobot::PictureText(1));
  ASSERT_TRUE(server_.CaptureForNextClient());
  EXPECT_EQ(client.ReadUntil("\xFF\xD9"), part + FakeRobot::PictureText(2));
}

TEST_F(LiteralBytes, StreamWithStatusSendsAStatusPartAfterEachPicture) {
  RawClient client(server_.port());
  client.Send("GET /GetData.cgi?Status=true HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_.CaptureForNextClient());
  client.ReadUntil("\xFF\xD9");
  EXPECT_EQ(client.Read(46 + 98),
            "--WINBONDBOUDARY\r\nContent-Type: text/plain\r\n\r\n"
            "01"
            "0000"
            "000000000"
            "006"
            "000"
            "2"
            "1"
            "0"
            "000000"
            "0"
            "0"
            "00000015"
            "0000000000000000"
            "0"
            "000"
            "999999"
            "000"
            "000"
            "0000000000"
            "030"
            "015"
            "015"
            "0"
            "d4"
            "7e\r\n");
}

TEST_F(LiteralBytes, KeepAliveIsAnnouncedAndKept) {
  RawClient client(server_.port());
  for (const char* left : {"107999", "107998"}) {
    client.Send("GET /GetCamera.cgi HTTP/1.1\r\nConnection: Keep-Alive\r\n\r\n");
    const std::string expected =
        std::string("HTTP/1.0 200 OK\r\n") + kDateAndServer +
        "Connection: Keep-Alive\r\nKeep-Alive: timeout=3600, max=" + left + "\r\n" + kNoCache +
        "Content-Type: text/plain\r\nContent-Length: 15\r\n\r\nFrequency = 50\n";
    EXPECT_EQ(client.Read(expected.size()), expected);
  }
}

TEST_F(LiteralBytes, UnknownPathGets404) {
  EXPECT_EQ(Get("/nothing.html"),
            std::string("HTTP/1.0 404 Not Found\r\n") + kDateAndServer +
                "Connection: close\r\nContent-Type: text/html\r\nContent-Length: 92\r\n\r\n"
                "<HTML><HEAD><TITLE>404 Not Found</TITLE></HEAD>\n"
                "<BODY><H1>404 Not Found</H1>\n</BODY></HTML>\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
