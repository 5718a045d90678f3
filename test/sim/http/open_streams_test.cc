#include "rovio_sfm/sim/http/open_streams.h"

#include <gtest/gtest.h>

#include "sim/http/raw_client.h"

namespace rovio_sfm::sim {
namespace {

TEST(OpenStreams, DropCutsStreamsOfThatPathAndQuery) {
  std::string error;
  const auto listener = TcpListener::Open("127.0.0.1", 0, &error);
  RawClient client_a(listener->port());
  const auto a = listener->Accept();
  RawClient client_b(listener->port());
  const auto b = listener->Accept();
  OpenStreams streams;
  const OpenStreams::Entry entry_a(streams, "/GetData.cgi", "tag=a", *a);
  const OpenStreams::Entry entry_b(streams, "/GetData.cgi", "tag=b", *b);
  EXPECT_EQ(streams.Drop("/GetData.cgi", "tag=a"), 1);
  EXPECT_EQ(streams.Drop("/GetData.cgi", ""), 0);
  EXPECT_EQ(client_a.ReadToEnd(), "");
  EXPECT_TRUE(b->Write("still here", 1000));
  EXPECT_EQ(client_b.Read(10), "still here");
}

TEST(OpenStreams, ForgetsStreamsThatEnded) {
  std::string error;
  const auto listener = TcpListener::Open("127.0.0.1", 0, &error);
  RawClient client(listener->port());
  const auto connection = listener->Accept();
  OpenStreams streams;
  { const OpenStreams::Entry entry(streams, "/GetData.cgi", "", *connection); }
  EXPECT_EQ(streams.Drop("/GetData.cgi", ""), 0);
}

}  // namespace
}  // namespace rovio_sfm::sim
