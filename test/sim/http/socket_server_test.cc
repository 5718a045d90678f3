#include "rovio_sfm/sim/http/socket_server.h"

#include <gtest/gtest.h>

#include <atomic>

#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

// Greets, then answers every byte with itself until the client ends.
void Echo(TcpConnection& connection) {
  connection.Write("hello", 1000);
  std::string received;
  while (connection.Read(100, -1, &received) == ReadStatus::kData) {
    connection.Write(received, 1000);
    received.clear();
  }
}

TEST(SocketServer, ServesManyClientsAtOnce) {
  SocketServer server({}, Echo);
  std::string error;
  ASSERT_TRUE(server.Start(&error)) << error;
  RawClient a(server.port()), b(server.port());
  EXPECT_EQ(a.Read(5), "hello");
  EXPECT_EQ(b.Read(5), "hello");
  a.Send("a");
  b.Send("b");
  EXPECT_EQ(b.Read(1), "b");
  EXPECT_EQ(a.Read(1), "a");
}

TEST(SocketServer, SurplusClientsWaitForAPlace) {
  SocketServerOptions options;
  options.max_connections = 2;
  SocketServer server(options, Echo);
  std::string error;
  ASSERT_TRUE(server.Start(&error)) << error;
  auto first = std::make_unique<RawClient>(server.port());
  RawClient second(server.port());
  EXPECT_EQ(first->Read(5), "hello");
  EXPECT_EQ(second.Read(5), "hello");
  RawClient third(server.port());
  EXPECT_TRUE(third.is_connected());
  EXPECT_FALSE(third.HasBytesWithin(20));
  first.reset();
  EXPECT_EQ(third.Read(5), "hello");
}

TEST(SocketServer, StopEndsConnectionsAndRefusesNewOnes) {
  SocketServer server({}, Echo);
  std::string error;
  ASSERT_TRUE(server.Start(&error)) << error;
  RawClient client(server.port());
  EXPECT_EQ(client.Read(5), "hello");
  server.Stop();
  EXPECT_EQ(client.ReadToEnd(), "");
}

TEST(SocketServer, ComesBackOnTheSamePortAfterItsAbsence) {
  SocketServer server({}, Echo);
  std::string error;
  ASSERT_TRUE(server.Start(&error)) << error;
  const int port = server.port();
  RawClient before(port);
  EXPECT_EQ(before.Read(5), "hello");
  server.GoAway(std::chrono::milliseconds(100));
  EXPECT_EQ(before.ReadToEnd(), "");
  int num_refused = 0;
  std::string greeting;
  while (greeting.empty() && num_refused < 1'000'000) {
    RawClient after(port);
    if (after.is_connected()) greeting = after.Read(5);
    num_refused += greeting.empty() ? 1 : 0;
  }
  EXPECT_EQ(greeting, "hello");
  EXPECT_GT(num_refused, 0);
}

TEST(SocketServer, NamesOptionsOutOfRange) {
  SocketServerOptions options;
  options.port = 65536;
  std::string error;
  EXPECT_FALSE(SocketServer(options, Echo).Start(&error));
  EXPECT_EQ(error, "socket.port = 65536: expected 0 to 65535");
}

}  // namespace
}  // namespace rovio_sfm::sim
