#include "rovio_sfm/sim/http/mjpeg_push.h"

#include <gtest/gtest.h>

#include <thread>

#include "rovio_sfm/sim/http/capture_loop.h"
#include "sim/http/face_fixture.h"
#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

class MjpegPush : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    listener_ = TcpListener::Open("127.0.0.1", 0, &error);
    ASSERT_NE(listener_, nullptr) << error;
    client_ = std::make_unique<RawClient>(listener_->port());
    connection_ = listener_->Accept();
  }
  void TearDown() override {
    context_.stop.Request();
    context_.frames.Close();
    if (pushing_.joinable()) pushing_.join();
  }
  void StartPush(const std::string& query) {
    HttpRequest request;
    request.target_query = query;
    CaptureOnce(context_);
    pushing_ = std::thread([this, request] {
      PushStream(*connection_, request, {}, *context_.frames.Latest(), context_);
    });
    client_->ReadUntil("\r\n\r\n");
  }

  static HttpFaceOptions ImpatientOptions() {
    HttpFaceOptions options;
    options.stream_idle_ns = 1'000'000;
    return options;
  }

  FakeRobot robot_;
  ServerContext context_{ImpatientOptions(), robot_, [] { return int64_t{0}; }};
  std::unique_ptr<TcpListener> listener_;
  std::unique_ptr<TcpConnection> connection_;
  std::unique_ptr<RawClient> client_;
  std::thread pushing_;
};

TEST_F(MjpegPush, IdleStreamSendsBareLineEnds) {
  StartPush("");
  client_->ReadUntil("\xFF\xD9");
  EXPECT_EQ(client_->Read(6), "\r\n\r\n\r\n");
}

TEST_F(MjpegPush, IdleStreamWithStatusSendsStatusParts) {
  StartPush("Status=true");
  client_->ReadUntil("\xFF\xD9");
  const std::string part = client_->Read(kStatusPartHead.size() + 98);
  EXPECT_EQ(part.substr(0, kStatusPartHead.size()), kStatusPartHead);
  EXPECT_EQ(client_->Read(part.size()), part);
}

TEST_F(MjpegPush, EndsWhenTheClientIsGone) {
  StartPush("");
  client_.reset();
  pushing_.join();
}

TEST_F(MjpegPush, QuirkResetsTheStreamAfterItsParts) {
  std::string error;
  context_.quirks.With([&](Quirks& quirks) { return quirks.Set("reset_stream", 3, 0, &error); });
  StartPush("");
  pushing_.join();
  connection_.reset();
  client_->ReadToEnd();
  EXPECT_TRUE(client_->was_reset());
}

TEST_F(MjpegPush, WaitForAFreshPictureEndsWhenTheClientIsGone) {
  client_.reset();
  EXPECT_FALSE(WaitForFreshPicture(*connection_, context_.frames));
}

TEST_F(MjpegPush, SilenceEndsWithTheServer) {
  std::string error;
  context_.quirks.With([&](Quirks& quirks) { return quirks.Set("silence", 10, 0, &error); });
  context_.stop.Request();
  EXPECT_FALSE(WaitWhileSilent(context_));
}

}  // namespace
}  // namespace rovio_sfm::sim
