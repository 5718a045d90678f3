#include "rovio_sfm/sim/http/http_request.h"

#include <gtest/gtest.h>

#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

TEST(ParseRequestHead, TakesWhatWorkingClientsSend) {
  const auto request = ParseRequestHead(
      "GET  //rev.cgi?Cmd=nav&action=1  HTTP/1.1\nconnection:  keep-alive\n"
      "Authorization: Basic abc=\r\n");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->method, "GET");
  EXPECT_EQ(request->path, "/rev.cgi");
  EXPECT_EQ(request->query, "Cmd=nav&action=1");
  EXPECT_TRUE(request->keep_alive);
  EXPECT_EQ(request->authorization, "Basic abc=");
}

TEST(ParseRequestHead, WithoutConnectionHeaderThereIsNoKeepAlive) {
  EXPECT_FALSE(ParseRequestHead("GET / HTTP/1.1\r\n")->keep_alive);
}

TEST(ParseRequestHead, DecodesThePathOnly) {
  const auto request = ParseRequestHead("GET /Jpeg/CamImg%5B0%5D.jpg?a=%20\n");
  EXPECT_EQ(request->path, "/Jpeg/CamImg[0].jpg");
  EXPECT_EQ(request->query, "a=%20");
}

TEST(ParseRequestHead, RefusesGarbage) {
  EXPECT_FALSE(ParseRequestHead(""));
  EXPECT_FALSE(ParseRequestHead("GET\r\n"));
  EXPECT_FALSE(ParseRequestHead("GET rev.cgi HTTP/1.0\r\n"));
  EXPECT_FALSE(ParseRequestHead("GET / FTP/1.0\r\n"));
  EXPECT_FALSE(ParseRequestHead("GET /a%00b HTTP/1.0\r\n"));
  EXPECT_FALSE(ParseRequestHead("POST / HTTP/1.0\r\nContent-Length: -1\r\n"));
  EXPECT_FALSE(ParseRequestHead("POST / HTTP/1.0\r\nContent-Length: 99999999999999999999\r\n"));
  EXPECT_FALSE(ParseRequestHead("POST / HTTP/1.0\r\nContent-Length: 1\nContent-Length: 1\n"));
}

class Requests : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    listener_ = TcpListener::Open("127.0.0.1", 0, &error);
    ASSERT_NE(listener_, nullptr) << error;
    client_ = std::make_unique<RawClient>(listener_->port());
    connection_ = listener_->Accept();
    reader_ = std::make_unique<RequestReader>(*connection_, 1000, 1000);
  }
  RequestStatus Next() { return reader_->ReadNext(&request_); }

  std::unique_ptr<TcpListener> listener_;
  std::unique_ptr<RawClient> client_;
  std::unique_ptr<TcpConnection> connection_;
  std::unique_ptr<RequestReader> reader_;
  HttpRequest request_;
};

TEST_F(Requests, ArePulledApartWhenPipelined) {
  client_->Send("\r\n\nGET /a HTTP/1.0\r\n\r\nPOST /b?x=1 HTTP/1.0\nContent-Length: 5\n\ny=2\r\n");
  client_->Send("GET /c HTTP/1.0\n\n");
  EXPECT_EQ(Next(), RequestStatus::kComplete);
  EXPECT_EQ(request_.path, "/a");
  EXPECT_EQ(Next(), RequestStatus::kComplete);
  EXPECT_EQ(request_.path, "/b");
  EXPECT_EQ(request_.query, "y=2");
  EXPECT_EQ(request_.target_query, "x=1");
  EXPECT_EQ(Next(), RequestStatus::kComplete);
  EXPECT_EQ(request_.path, "/c");
}

TEST_F(Requests, WithALongHeadAreBad) {
  client_->Send("GET /" + std::string(kMaxHeaderLineBytes, 'x'));
  EXPECT_EQ(Next(), RequestStatus::kBad);
}

TEST_F(Requests, WithManyHeadersAreBad) {
  client_->Send("GET / HTTP/1.0\r\n");
  for (int i = 0; i < 100; ++i) client_->Send("X-Filler: 0123456789\r\n");
  EXPECT_EQ(Next(), RequestStatus::kBad);
}

TEST_F(Requests, WithALongBodyAreReadAndMarked) {
  client_->Send("POST /a HTTP/1.0\r\nContent-Length: 20000\r\n\r\n" + std::string(20000, 'x') +
                "GET /b HTTP/1.0\r\n\r\n");
  EXPECT_EQ(Next(), RequestStatus::kPostTooLarge);
  EXPECT_EQ(Next(), RequestStatus::kComplete);
  EXPECT_EQ(request_.path, "/b");
}

TEST_F(Requests, EndWithTheConnection) {
  client_->Send("GET /a HTTP/1.0\r\n");
  client_.reset();
  EXPECT_EQ(Next(), RequestStatus::kClosed);
}

}  // namespace
}  // namespace rovio_sfm::sim
