#include "rovio_sfm/sim/http/tcp_socket.h"

#include <gtest/gtest.h>

#include <thread>

#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

class TcpSocket : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    listener_ = TcpListener::Open("127.0.0.1", 0, &error);
    ASSERT_NE(listener_, nullptr) << error;
  }

  std::unique_ptr<TcpListener> listener_;
};

TEST_F(TcpSocket, CarriesBytesBothWays) {
  RawClient client(listener_->port());
  const auto connection = listener_->Accept();
  client.Send("question");
  std::string received;
  EXPECT_EQ(connection->Read(100, 1000, &received), ReadStatus::kData);
  EXPECT_EQ(received, "question");
  EXPECT_TRUE(connection->Write("answer", 1000));
  EXPECT_EQ(client.Read(6), "answer");
}

TEST_F(TcpSocket, ReadTellsTimeOutFromTheEnd) {
  auto client = std::make_unique<RawClient>(listener_->port());
  const auto connection = listener_->Accept();
  std::string received;
  EXPECT_EQ(connection->Read(100, 0, &received), ReadStatus::kTimeout);
  EXPECT_FALSE(connection->IsPeerGone());
  client.reset();
  EXPECT_EQ(connection->Read(100, 1000, &received), ReadStatus::kEnd);
  EXPECT_TRUE(connection->IsPeerGone());
}

TEST_F(TcpSocket, WriteGivesUpOnAClientThatTakesNothing) {
  RawClient client(listener_->port());
  const auto connection = listener_->Accept();
  EXPECT_FALSE(connection->Write(std::string(64 << 20, 'x'), 10));
}

TEST_F(TcpSocket, ShutdownEndsABlockedRead) {
  RawClient client(listener_->port());
  const auto connection = listener_->Accept();
  std::string received;
  ReadStatus status = ReadStatus::kData;
  std::thread reading([&] { status = connection->Read(100, -1, &received); });
  connection->Shutdown();
  reading.join();
  EXPECT_EQ(status, ReadStatus::kEnd);
}

TEST_F(TcpSocket, ResetOnCloseIsSeenByTheClient) {
  RawClient client(listener_->port());
  auto connection = listener_->Accept();
  connection->ResetOnClose();
  connection.reset();
  client.ReadToEnd();
  EXPECT_TRUE(client.was_reset());
}

TEST_F(TcpSocket, CloseEndsAccept) {
  std::unique_ptr<TcpConnection> accepted;
  std::thread accepting([&] { accepted = listener_->Accept(); });
  listener_->Close();
  accepting.join();
  EXPECT_EQ(accepted, nullptr);
}

TEST_F(TcpSocket, OpenNamesATakenPortAndABadAddress) {
  std::string error;
  EXPECT_EQ(TcpListener::Open("127.0.0.1", listener_->port(), &error), nullptr);
  EXPECT_NE(error.find(std::to_string(listener_->port())), std::string::npos);
  EXPECT_EQ(TcpListener::Open("localhost", 0, &error), nullptr);
  EXPECT_EQ(error, "not an IPv4 address: localhost");
}

}  // namespace
}  // namespace rovio_sfm::sim
