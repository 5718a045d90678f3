#include "rovio_sfm/sim/http/rovio_http_server.h"

#include <gtest/gtest.h>

#include "sim/http/fake_robot.h"
#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

class RovioHttpServerTest : public testing::Test {
 protected:
  void Start(RovioHttpServerOptions options = {}) {
    server_ = std::make_unique<RovioHttpServer>(options, robot_, [] { return int64_t{0}; });
    std::string error;
    ASSERT_TRUE(server_->Start(&error)) << error;
  }

  FakeRobot robot_;
  std::unique_ptr<RovioHttpServer> server_;
};

constexpr char kStill[] = "GET /Jpeg/CamImg1.jpg HTTP/1.1\r\nConnection: Keep-Alive\r\n\r\n";

TEST_F(RovioHttpServerTest, EveryStillIsAFreshPicture) {
  Start();
  RawClient client(server_->port());
  for (int number = 1; number <= 3; ++number) {
    client.Send(kStill);
    ASSERT_TRUE(server_->CaptureForNextClient());
    const std::string reply = client.ReadUntil("\xFF\xD9");
    EXPECT_EQ(BodyOf(reply), FakeRobot::PictureText(number));
  }
}

TEST_F(RovioHttpServerTest, CapturesByItselfOnceAsked) {
  Start();
  server_->StartCapturing();
  RawClient client(server_->port());
  client.Send(kStill);
  EXPECT_EQ(BodyOf(client.ReadUntil("\xFF\xD9")).substr(0, 10), "\xFF\xD8 picture");
}

TEST_F(RovioHttpServerTest, StopEndsHangingStillsAndStreams) {
  Start();
  robot_.has_pictures = false;
  server_->StartCapturing();
  RawClient still(server_->port()), stream(server_->port());
  still.Send(kStill);
  stream.Send("GET /GetData.cgi HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_->WaitForPictureDemand());
  server_->Stop();
  EXPECT_EQ(still.ReadToEnd(), "");
  EXPECT_EQ(stream.ReadToEnd(), "");
}

TEST_F(RovioHttpServerTest, DropDataCutsTheTaggedStream) {
  Start();
  RawClient stream(server_->port());
  stream.Send("GET /GetData.cgi?tag=7 HTTP/1.0\r\n\r\n");
  ASSERT_TRUE(server_->CaptureForNextClient());
  stream.ReadUntil("\xFF\xD9");
  EXPECT_EQ(BodyOf(Exchange(server_->port(), "GET /DropData.cgi?Query=tag%3D7 HTTP/1.0\r\n\r\n")),
            "Found = 1\n");
  EXPECT_EQ(stream.ReadToEnd(), "");
}

TEST_F(RovioHttpServerTest, RebootsAfterTheReplyAndComesBack) {
  RovioHttpServerOptions options;
  options.face.reboot_ns = 50'000'000;
  Start(options);
  const std::string reply =
      Exchange(server_->port(), "GET /Reboot.cgi HTTP/1.1\r\nConnection: Keep-Alive\r\n\r\n");
  EXPECT_EQ(BodyOf(reply), "Return = OK\n");
  EXPECT_NE(reply.find("Connection: close\r\n"), std::string::npos);
  std::string body;
  int num_failed = 0;
  while (body.empty() && num_failed < 1'000'000) {
    body = BodyOf(Exchange(server_->port(), "GET /GetCamera.cgi HTTP/1.0\r\n\r\n"));
    num_failed += body.empty() ? 1 : 0;
  }
  EXPECT_EQ(body, "Frequency = 50\n");
}

TEST_F(RovioHttpServerTest, TwentyClientsAreServedAndTheNextWaits) {
  Start();
  std::vector<std::unique_ptr<RawClient>> clients;
  const std::string request = "GET /GetCamera.cgi HTTP/1.0\r\nConnection: Keep-Alive\r\n\r\n";
  for (int i = 0; i < 20; ++i) {
    clients.push_back(std::make_unique<RawClient>(server_->port()));
    clients.back()->Send(request);
    EXPECT_NE(clients.back()->ReadUntil("= 50\n"), "");
  }
  RawClient surplus(server_->port());
  surplus.Send(request);
  EXPECT_FALSE(surplus.HasBytesWithin(20));
  clients.pop_back();
  EXPECT_NE(surplus.ReadUntil("= 50\n"), "");
}

TEST_F(RovioHttpServerTest, RefusesBadOptionsAndQuirks) {
  Start();
  std::string error;
  EXPECT_FALSE(server_->SetQuirk("nonsense", 1, &error));
  EXPECT_EQ(error, "no quirk is called nonsense");
  RovioHttpServerOptions options;
  options.socket.port = -1;
  RovioHttpServer bad(options, robot_, [] { return int64_t{0}; });
  EXPECT_FALSE(bad.Start(&error));
}

}  // namespace
}  // namespace rovio_sfm::sim
