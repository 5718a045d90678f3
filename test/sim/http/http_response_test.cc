#include "rovio_sfm/sim/http/http_response.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(SerializeHead, IsTheRobots) {
  HttpResponse response;
  response.body = "abc";
  EXPECT_EQ(SerializeHead(response, {true, 5}, 1'000'000'000, true),
            "HTTP/1.0 200 OK\r\nDate: Thu, 01 Jan 1970 00:00:01 GMT\r\nServer: WYM/1.0\r\n"
            "Connection: Keep-Alive\r\nKeep-Alive: timeout=3600, max=5\r\n"
            "Pragma: no-cache\r\nCache-Control: no-cache\r\n"
            "Expires: 01 Jan 1970 00:00:00 GMT\r\n"
            "Content-Type: text/plain\r\nContent-Length: 3\r\n\r\n");
}

TEST(SerializeHead, OfAnEndlessBodyHasNoLength) {
  const std::string head = SerializeHead({}, {}, 0, false);
  EXPECT_EQ(head.find("Content-Length"), std::string::npos);
  EXPECT_NE(head.find("Connection: close\r\n"), std::string::npos);
}

TEST(ErrorPage, NamesTheReason) {
  EXPECT_EQ(ErrorPage(400).reason, "Bad Request");
  EXPECT_EQ(ErrorPage(403).reason, "Forbidden");
  EXPECT_EQ(ErrorPage(404).content_type, "text/html");
  EXPECT_EQ(LoginRequired("Rovio").extra_headers, "WWW-Authenticate: Basic realm=\"Rovio\"\r\n");
}

}  // namespace
}  // namespace rovio_sfm::sim
