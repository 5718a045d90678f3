#include "rovio_sfm/ros/web_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <utility>

namespace rovio_sfm {
namespace {

// Answers with what it was asked.
WebAnswer Echo(const WebRequest& request) {
  const std::string text = request.method + " " + request.path + " since=" + request.since +
                           " host=" + request.host + " origin=" + request.origin.value_or("none") +
                           " token=" + request.token + " body=" + request.body;
  return {200, "text/plain", std::make_shared<const std::string>(text), "run-7"};
}

httplib::Client ClientOf(const WebServer& server) {
  return httplib::Client("127.0.0.1", server.port());
}

// A connection that says what it is told, and nothing of its own.
class RawClient {
 public:
  explicit RawClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_connected_ = ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool IsConnected() const { return is_connected_; }
  void Send(const std::string& text) { ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }

  // All until the server hangs up.
  std::string Receive() {
    std::string all, part(4096, '\0');
    for (ssize_t count = 0; (count = ::recv(socket_, part.data(), part.size(), 0)) > 0;) {
      all.append(part, 0, static_cast<size_t>(count));
    }
    return all;
  }

 private:
  int socket_;
  bool is_connected_ = false;
};

TEST(WebServer, HandsOnWhatTheGuardLooksAt) {
  WebServer server("127.0.0.1", 0, Echo);
  const std::string host = "127.0.0.1:" + std::to_string(server.port());
  const auto get =
      ClientOf(server).Get("/api/cloud?since=run-3", {{"Origin", "http://evil.example"}});
  ASSERT_TRUE(get);
  EXPECT_EQ(get->status, 200);
  EXPECT_EQ(get->body,
            "GET /api/cloud since=run-3 host=" + host + " origin=http://evil.example token= body=");
  EXPECT_EQ(get->get_header_value("X-Revision"), "run-7");
  const auto post =
      ClientOf(server).Post("/api/save_map", {{"X-Rovio-Token", "abc"}}, "{}", "application/json");
  ASSERT_TRUE(post);
  EXPECT_EQ(post->body,
            "POST /api/save_map since= host=" + host + " origin=none token=abc body={}");
}

TEST(WebServer, KeepsBrowsersToThePage) {
  WebServer server("127.0.0.1", 0, Echo);
  const auto reply = ClientOf(server).Get("/");
  ASSERT_TRUE(reply);
  EXPECT_NE(reply->get_header_value("Content-Security-Policy").find("frame-ancestors 'none'"),
            std::string::npos);
  EXPECT_EQ(reply->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(reply->get_header_value("Connection"), "close");
  EXPECT_FALSE(reply->has_header("Access-Control-Allow-Origin"));
}

TEST(WebServer, AHeaderThatCameTwiceIsNone) {
  WebServer server("127.0.0.1", 0, Echo);
  RawClient client(server.port());
  client.Send("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n");
  EXPECT_NE(client.Receive().find(" host= "), std::string::npos);
}

TEST(WebServer, HandsOnOtherMethods) {
  WebServer server("127.0.0.1", 0, Echo);
  for (const char* method : {"OPTIONS", "PUT", "DELETE", "HEAD"}) {
    RawClient client(server.port());
    client.Send(std::string(method) + " / HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_EQ(client.Receive().substr(0, 12), "HTTP/1.1 200") << method;
  }
}

TEST(WebServer, APostWithoutABodyIsAnsweredAtOnce) {
  WebServer server("127.0.0.1", 0, Echo);
  RawClient client(server.port());
  client.Send("POST /api/save_map HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_NE(client.Receive().find("POST /api/save_map"), std::string::npos);
}

TEST(WebServer, RefusesLargeBodies) {
  std::atomic<int> num_handled{0};
  WebServer server("127.0.0.1", 0, [&](const WebRequest& request) {
    ++num_handled;
    return Echo(request);
  });
  const auto reply =
      ClientOf(server).Post("/api/save_map", std::string(5000, 'x'), "application/json");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 413);
  EXPECT_EQ(reply->body, "the body is too large: at most 4096 bytes are taken\n");
  EXPECT_EQ(num_handled, 0);
}

TEST(WebServer, SaysWhatItRefusesUnheard) {
  WebServer server("127.0.0.1", 0, Echo);
  const std::string much(9000, 'x');
  const std::pair<std::string, std::string> cases[] = {
      {"FOO / HTTP/1.1\r\nHost: localhost\r\n\r\n", "not a request that HTTP/1.1 knows"},
      {"GET / HTTP/1.1\r\nX-More: " + much + "\r\n\r\n", "a header of more than 8 KiB"},
      {"GET /" + much + " HTTP/1.1\r\nHost: localhost\r\n\r\n", "the address is too long"},
      {"GET / HTTP/1.1\r\nRange: all\r\n\r\n", "header Range: expected bytes="},
      {"POST / HTTP/1.1\r\nContent-Length: 9000\r\n\r\n" + much, "the body is too large"}};
  for (const auto& [request, sentence] : cases) {
    RawClient client(server.port());
    client.Send(request);
    const std::string answer = client.Receive();
    EXPECT_NE(answer.find("\r\n\r\n"), std::string::npos) << answer;
    EXPECT_NE(answer.find(sentence), std::string::npos) << answer;
  }
}

TEST(WebServer, ARangeBeyondTheAnswerGetsTheAnswer) {
  WebServer server("127.0.0.1", 0, Echo);
  const auto whole = ClientOf(server).Get("/page");
  ASSERT_TRUE(whole);
  for (const char* range : {"bytes=0-99999999", "bytes=9999999-", "bytes=2-4,1-2", "bytes=-9999"}) {
    const auto reply = ClientOf(server).Get("/page", {{"Range", range}});
    ASSERT_TRUE(reply) << range;
    EXPECT_EQ(reply->status, 200) << range;
    EXPECT_EQ(reply->body, whole->body) << range;
  }
}

TEST(WebServer, DropsRequestsWithoutAnEnd) {
  WebServer server("127.0.0.1", 0, Echo);
  RawClient many_headers(server.port()), long_line(server.port()), many_bytes(server.port());
  std::string headers = "GET / HTTP/1.1\r\n";
  for (int i = 0; i < 5000; ++i) headers += "X-More: 0123456789\r\n";
  many_headers.Send(headers + "\r\n");
  EXPECT_EQ(many_headers.Receive().find("200"), std::string::npos);
  long_line.Send("GET /" + std::string(100'000, 'x') + " HTTP/1.1\r\n\r\n");
  EXPECT_EQ(long_line.Receive().find("200"), std::string::npos);
  many_bytes.Send(
      "POST /api/save_map HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n");
  for (int i = 0; i < 100; ++i) many_bytes.Send("400\r\n" + std::string(0x400, 'x') + "\r\n");
  EXPECT_EQ(many_bytes.Receive().find("200"), std::string::npos);
  EXPECT_TRUE(ClientOf(server).Get("/"));
}

TEST(WebServer, DropsClientsThatHang) {
  WebLimits limits;
  limits.num_threads = 1;
  limits.request_s = 0.05;
  WebServer server("127.0.0.1", 0, Echo, limits);
  RawClient silent(server.port()), slow(server.port());
  slow.Send("GET / HTTP/1.1\r\nHos");
  const auto reply = ClientOf(server).Get("/");  // behind both, for the only thread
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 200);
  EXPECT_EQ(silent.Receive(), "");
}

TEST(WebServer, DropsClientsThatDoNotTakeTheirAnswer) {
  WebLimits limits;
  limits.num_threads = 1;
  limits.answer_s = 0.05;
  const auto large = std::make_shared<const std::string>(64 << 20, 'x');
  WebServer server(
      "127.0.0.1", 0,
      [&](const WebRequest& request) {
        return request.path == "/large" ? WebAnswer{200, "text/plain", large, ""} : Echo(request);
      },
      limits);
  RawClient deaf(server.port());
  deaf.Send("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(ClientOf(server).Get("/"));
  EXPECT_LT(deaf.Receive().size(), large->size());
}

TEST(WebServer, StopsThoughClientsHangAndHandlersRun) {
  std::promise<void> is_asked, may_answer;
  WebServer server("127.0.0.1", 0, [&](const WebRequest& request) {
    is_asked.set_value();
    may_answer.get_future().wait();
    return Echo(request);
  });
  RawClient silent(server.port()), asking(server.port());
  asking.Send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  is_asked.get_future().wait();
  auto stopped = std::async(std::launch::async, [&] { server.Stop(); });
  EXPECT_EQ(silent.Receive(), "");
  may_answer.set_value();
  stopped.get();
  EXPECT_FALSE(ClientOf(server).Get("/"));
}

TEST(WebServer, StopsAtOnceAndServesAtOnce) {
  for (int i = 0; i < 20; ++i) {
    WebServer unasked("127.0.0.1", 0, Echo);
    WebServer asked("127.0.0.1", 0, Echo);
    EXPECT_TRUE(ClientOf(asked).Get("/"));
  }
}

TEST(WebServer, SaysThatAPortIsTaken) {
  WebServer first("127.0.0.1", 0, Echo);
  try {
    WebServer second("127.0.0.1", first.port(), Echo);
    FAIL() << "both listen on port " << first.port();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot listen on 127.0.0.1:" + std::to_string(first.port()) +
                                ": Address already in use; ~address and ~port choose another");
  }
}

TEST(WebServer, AHandlerThatThrowsCostsItsAnswerOnly) {
  WebServer server("127.0.0.1", 0, [](const WebRequest& request) -> WebAnswer {
    if (request.path == "/throw") throw std::runtime_error("secret");
    return Echo(request);
  });
  const auto reply = ClientOf(server).Get("/throw");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 500);
  EXPECT_EQ(reply->body.find("secret"), std::string::npos);
  EXPECT_TRUE(ClientOf(server).Get("/"));
}

}  // namespace
}  // namespace rovio_sfm
