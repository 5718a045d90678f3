#include "rovio_sfm/rovio/curl_transport.h"

#include <gtest/gtest.h>

#include <future>
#include <thread>

#include "rovio/scripted_server.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxBody = 1000;

CurlTransportOptions OptionsFor(int port) {
  CurlTransportOptions options;
  options.host = "127.0.0.1";
  options.port = port;
  options.connect_timeout_s = 0.2;
  options.first_byte_timeout_s = 0.2;
  options.between_bytes_timeout_s = 0.2;
  options.total_timeout_s = 2.0;
  return options;
}

HttpResponse GetFrom(const std::string& answer,
                     ScriptedServer::Afterwards afterwards = ScriptedServer::Afterwards::kClose) {
  ScriptedServer server(answer, afterwards);
  CurlTransport transport(OptionsFor(server.Port()), {});
  return transport.Get("/x", kMaxBody);
}

TEST(CurlTransport, TakesAnswersOfTheRobot) {
  const HttpResponse response = GetFrom(
      "HTTP/1.0 200 OK\r\nServer: WYM/1.0\r\nConnection: close\r\nContent-Type: text/plain\r\n"
      "Content-Length: 5\r\n\r\nhello");
  EXPECT_TRUE(response.IsOk()) << response.message;
  EXPECT_EQ(response.body, "hello");
  EXPECT_EQ(response.content_type, "text/plain");
}

TEST(CurlTransport, TakesLineFeedsAloneAndNoLength) {
  const HttpResponse response = GetFrom("HTTP/1.0 200 OK\nContent-Type: text/plain\n\nhello");
  EXPECT_TRUE(response.IsOk()) << response.message;
  EXPECT_EQ(response.body, "hello");
}

TEST(CurlTransport, SaysTheStatusOfARefusal) {
  const HttpResponse response = GetFrom("HTTP/1.0 401 Unauthorized\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(response.fault, HttpFault::kNone);
  EXPECT_EQ(response.status, 401);
}

TEST(CurlTransport, FollowsNoRedirect) {
  ScriptedServer target("HTTP/1.0 200 OK\r\nContent-Length: 0\r\n\r\n",
                        ScriptedServer::Afterwards::kClose);
  const HttpResponse response =
      GetFrom("HTTP/1.0 302 Found\r\nLocation: http://127.0.0.1:" + std::to_string(target.Port()) +
              "/\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(response.status, 302);
  EXPECT_EQ(target.NumConnections(), 0);
}

TEST(CurlTransport, CapsTheBodyAnnouncedOrNot) {
  EXPECT_EQ(GetFrom("HTTP/1.0 200 OK\r\n\r\n" + std::string(kMaxBody + 1, 'x')).fault,
            HttpFault::kTooLarge);
  EXPECT_EQ(GetFrom("HTTP/1.0 200 OK\r\nContent-Length: 1001\r\n\r\nx").fault,
            HttpFault::kTooLarge);
}

TEST(CurlTransport, CapsHeaderBytesAndLines) {
  std::string long_header = "HTTP/1.0 200 OK\r\n", many_lines = long_header;
  for (int i = 0; i < 20; ++i) long_header += "A: " + std::string(1000, 'a') + "\r\n";
  for (int i = 0; i < 100; ++i) many_lines += "A: b\r\n";
  EXPECT_EQ(GetFrom(long_header + "\r\n").fault, HttpFault::kTooLarge);
  EXPECT_EQ(GetFrom(many_lines + "\r\n").fault, HttpFault::kTooLarge);
}

TEST(CurlTransport, RefusesNegativeOverflowingAndDuplicateLengths) {
  for (const char* const lengths :
       {"Content-Length: -5\r\n", "Content-Length: 99999999999999999999999\r\n",
        "Content-Length: 5\r\nContent-Length: 6\r\n"}) {
    const HttpResponse response =
        GetFrom(std::string("HTTP/1.0 200 OK\r\n") + lengths + "\r\nhello");
    EXPECT_EQ(response.fault, HttpFault::kMalformed) << lengths;
  }
}

TEST(CurlTransport, SeesAnAnswerThatEndsInTheMiddle) {
  EXPECT_EQ(GetFrom("HTTP/1.0 200 OK\r\nContent-Length: 50\r\n\r\nhel").fault,
            HttpFault::kInterrupted);
  EXPECT_EQ(GetFrom("").fault, HttpFault::kInterrupted);
  EXPECT_EQ(GetFrom("SSH-2.0-OpenSSH\r\n").fault, HttpFault::kMalformed);
}

TEST(CurlTransport, EndsWaitsForTheFirstByteAndBetweenBytes) {
  const auto hold = ScriptedServer::Afterwards::kHold;
  EXPECT_EQ(GetFrom("", hold).fault, HttpFault::kTimeout);
  EXPECT_EQ(GetFrom("HTTP/1.0 200 OK\r\nContent-Length: 50\r\n\r\nhel", hold).fault,
            HttpFault::kTimeout);
}

TEST(CurlTransport, SaysThatNobodyListens) {
  int port = 0;
  {
    ScriptedServer gone("", ScriptedServer::Afterwards::kClose);
    port = gone.Port();
  }
  CurlTransport transport(OptionsFor(port), {});
  EXPECT_EQ(transport.Get("/x", kMaxBody).fault, HttpFault::kConnect);
}

TEST(CurlTransport, SendsTheLoginInItsHeaderOnly) {
  ScriptedServer server("HTTP/1.0 200 OK\r\nContent-Length: 0\r\n\r\n",
                        ScriptedServer::Afterwards::kClose);
  CurlTransport transport(OptionsFor(server.Port()), {"admin", "secret"});
  EXPECT_TRUE(transport.Get("/x?y=1", kMaxBody).IsOk());
  const std::string request = server.LastRequest();
  EXPECT_NE(request.find("GET /x?y=1 HTTP/1.1\r\n"), std::string::npos);
  EXPECT_NE(request.find("Authorization: Basic YWRtaW46c2VjcmV0\r\n"), std::string::npos);
  EXPECT_NE(request.find("Connection: Keep-Alive\r\n"), std::string::npos);
}

TEST(CurlTransport, HandsOnAStreamUntilTheReceiverHasEnough) {
  ScriptedServer server("HTTP/1.0 200 OK\r\nContent-Type: multipart/x;boundary=b\r\n\r\nhello",
                        ScriptedServer::Afterwards::kHold);
  CurlTransport transport(OptionsFor(server.Port()), {});
  std::string type, bytes;
  const HttpResponse response =
      transport.Stream("/x", {[&](int status, const std::string& content_type) {
                                type = content_type;
                                return status == 200;
                              },
                              [&](std::string_view more) {
                                bytes += more;
                                return bytes.size() < 5;
                              }});
  EXPECT_EQ(response.fault, HttpFault::kCancelled);
  EXPECT_EQ(type, "multipart/x;boundary=b");
  EXPECT_EQ(bytes, "hello");
}

TEST(CurlTransport, CancelEndsAStreamAtOnceAndForGood) {
  ScriptedServer server("HTTP/1.0 200 OK\r\nContent-Type: multipart/x;boundary=b\r\n\r\nhello",
                        ScriptedServer::Afterwards::kHold);
  CurlTransportOptions options = OptionsFor(server.Port());
  options.between_bytes_timeout_s = 60.0;
  CurlTransport transport(options, {});
  std::promise<void> begun;
  std::thread canceller([&] {
    begun.get_future().wait();
    transport.Cancel();
  });
  const HttpResponse response =
      transport.Stream("/x", {[](int, const std::string&) { return true; },
                              [&](std::string_view) {
                                begun.set_value();
                                return true;
                              }});
  canceller.join();
  EXPECT_EQ(response.fault, HttpFault::kCancelled);
  EXPECT_EQ(transport.Get("/x", kMaxBody).fault, HttpFault::kCancelled);
}

TEST(CurlTransportOptions, TakeHostNamesOnly) {
  std::string error;
  CurlTransportOptions options;
  for (const char* const host : {"192.168.10.18", "rovio1", "rovio-1.local"}) {
    options.host = host;
    EXPECT_TRUE(IsValid(options, &error)) << host;
  }
  for (const char* const host : {"", "http://rovio", "a b", "rovio/x", "user@rovio", "rovio:80",
                                 "-x", "rovio?x", "rovio#"}) {
    options.host = host;
    EXPECT_FALSE(IsValid(options, &error)) << host;
  }
  options.host = "rovio";
  options.port = 70000;
  EXPECT_FALSE(IsValid(options, &error));
}

}  // namespace
}  // namespace rovio_sfm
