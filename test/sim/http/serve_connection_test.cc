#include "rovio_sfm/sim/http/serve_connection.h"

#include <gtest/gtest.h>

#include "rovio_sfm/sim/http/rovio_http_server.h"
#include "rovio_sfm/util/rng.h"
#include "sim/http/fake_robot.h"
#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

class ServeConnectionTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    ASSERT_TRUE(server_.Start(&error)) << error;
  }
  std::string Send(const std::string& request) { return Exchange(server_.port(), request); }
  std::string Status(const std::string& request) { return Send(request).substr(0, 12); }
  void SetQuirk(const std::string& name, double value) {
    std::string error;
    ASSERT_TRUE(server_.SetQuirk(name, value, &error)) << error;
  }

  FakeRobot robot_;
  RovioHttpServer server_{RovioHttpServerOptions(), robot_, [] { return int64_t{0}; }};
};

TEST_F(ServeConnectionTest, TakesBareLineFeedsTwoBlanksAndTwoSlashes) {
  EXPECT_EQ(BodyOf(Send("GET  //rev.cgi?Cmd=nav&action=33\n\n")), "Cmd = nav\nresponses = 0\n");
}

TEST_F(ServeConnectionTest, PostEqualsGet) {
  EXPECT_EQ(BodyOf(Send("POST /rev.cgi HTTP/1.1\r\nContent-Length: 17\r\n\r\nCmd=nav&action=33")),
            "Cmd = nav\nresponses = 0\n");
}

TEST_F(ServeConnectionTest, TellsOfTooLongAPost) {
  const std::string reply =
      Send("POST /rev.cgi HTTP/1.0\r\nContent-Length: 10240\r\n\r\n" + std::string(10240, 'x'));
  EXPECT_EQ(reply.substr(0, 15), "HTTP/1.0 200 OK");
  EXPECT_EQ(BodyOf(reply), "Too many post data or not enmough memory.");
}

TEST_F(ServeConnectionTest, BadRequestsGet400) {
  EXPECT_EQ(Status("nonsense\r\n\r\n"), "HTTP/1.0 400");
  EXPECT_EQ(Status("GET /" + std::string(2000, 'x')), "HTTP/1.0 400");
  EXPECT_EQ(Status("POST /rev.cgi HTTP/1.0\r\nContent-Length: -5\r\n\r\n"), "HTTP/1.0 400");
}

TEST_F(ServeConnectionTest, SurvivesGarbage) {
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    std::string garbage = i % 2 == 0 ? "GET /rev.cgi?" : "";
    for (uint32_t j = rng.UniformInt(300); j > 0; --j) {
      garbage += static_cast<char>(rng.UniformInt(256));
    }
    Send(garbage + "\r\n\r\n");
  }
  EXPECT_EQ(Status("GET /GetVer.cgi HTTP/1.0\r\n\r\n"), "HTTP/1.0 200");
}

TEST_F(ServeConnectionTest, StillByPostIsNotFound) {
  EXPECT_EQ(Status("POST /Jpeg/CamImg1.jpg HTTP/1.0\r\n\r\n"), "HTTP/1.0 404");
}

TEST_F(ServeConnectionTest, StillsAndStreamsNeedALogin) {
  SetQuirk("require_login", 1);
  EXPECT_EQ(Status("GET /Jpeg/CamImg1.jpg HTTP/1.0\r\n\r\n"), "HTTP/1.0 401");
  EXPECT_EQ(Status("GET /GetData.cgi HTTP/1.0\r\n\r\n"), "HTTP/1.0 401");
}

TEST_F(ServeConnectionTest, QuirkResetsEverySecondRequest) {
  SetQuirk("reset_every", 2);
  EXPECT_EQ(Status("GET /GetVer.cgi HTTP/1.0\r\n\r\n"), "HTTP/1.0 200");
  RawClient client(server_.port());
  client.Send("GET /GetVer.cgi HTTP/1.0\r\n\r\n");
  EXPECT_EQ(client.ReadToEnd(), "");
  EXPECT_TRUE(client.was_reset());
}

TEST_F(ServeConnectionTest, QuirkEndsStillsBeforeTheirLength) {
  SetQuirk("short_body", 1);
  RawClient client(server_.port());
  client.Send("GET /Jpeg/CamImg1.jpg HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_.CaptureForNextClient());
  const std::string reply = client.ReadToEnd();
  EXPECT_NE(reply.find("Content-Length: 15\r\n"), std::string::npos);
  EXPECT_EQ(BodyOf(reply), FakeRobot::PictureText(1).substr(0, 8));
}

TEST_F(ServeConnectionTest, QuirkLetsAHangingStillBlockEverybody) {
  SetQuirk("hang_blocks_all", 1);
  RawClient still(server_.port());
  still.Send("GET /Jpeg/CamImg1.jpg HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_.WaitForPictureDemand());
  RawClient other(server_.port());
  other.Send("GET /GetCamera.cgi HTTP/1.0\r\n\r\n");
  EXPECT_FALSE(other.HasBytesWithin(20));
  ASSERT_TRUE(server_.CaptureForNextClient());
  EXPECT_EQ(BodyOf(other.ReadToEnd()), "Frequency = 50\n");
}

TEST_F(ServeConnectionTest, SilentRobotSendsNothingAndItsOwnAddressStillWorks) {
  EXPECT_EQ(BodyOf(Send("GET /sim?quirk=silence&value=1000 HTTP/1.0\r\n\r\n")), "silence = 1000\n");
  RawClient client(server_.port());
  client.Send("GET /GetCamera.cgi HTTP/1.0\r\n\r\n");
  EXPECT_FALSE(client.HasBytesWithin(20));
  Send("GET /sim?quirk=none HTTP/1.0\r\n\r\n");
  EXPECT_EQ(BodyOf(client.ReadToEnd()), "Frequency = 50\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
