#include "rovio_sfm/app/web_guard.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

const WebPolicy kReading{{"robots.local"}, false, ""};
const WebPolicy kControlling{{"robots.local"}, true, "0123456789abcdef"};

WebRequest Get(const std::string& host) {
  WebRequest request;
  request.method = "GET";
  request.path = "/api/status";
  request.host = host;
  return request;
}

WebRequest Post(const std::string& token) {
  WebRequest request = Get("localhost:8090");
  request.method = "POST";
  request.path = "/api/finish_session";
  request.origin = "http://localhost:8090";
  request.content_type = "application/json";
  request.token = token;
  return request;
}

std::string ReasonOf(const WebRequest& request, const WebPolicy& policy = kReading) {
  const auto refusal = CheckRequest(request, policy);
  return refusal ? std::to_string(refusal->status) + " " + refusal->reason : "";
}

TEST(CheckRequest, AnswersToItsOwnNamesOnly) {
  for (const char* host : {"localhost:8090", "LOCALHOST", "127.0.0.1:8090", "[::1]:8090", "[::1]",
                           "192.168.10.2:80", "robots.local:8090", "Robots.Local"}) {
    EXPECT_EQ(ReasonOf(Get(host)), "") << host;
  }
  for (const char* host :
       {"evil.example:8090", "localhost.evil.example", "", "127.0.0.1.evil.example", "::1",
        "localhost:8090:1", "1.2.3", "xn--robots.local"}) {
    EXPECT_NE(ReasonOf(Get(host)), "") << host;
  }
  EXPECT_EQ(ReasonOf(Get("evil.example")),
            "403 Host 'evil.example': expected localhost, an address or one of ~hosts");
}

TEST(CheckRequest, RefusesForeignPages) {
  WebRequest request = Get("localhost:8090");
  request.origin = "http://localhost:8090";
  request.fetch_site = "same-origin";
  EXPECT_EQ(ReasonOf(request), "");
  for (const char* origin : {"http://evil.example", "null", "", "https://localhost:8090",
                             "http://localhost:9000", "http://127.0.0.1:8090"}) {
    request.origin = origin;
    EXPECT_NE(ReasonOf(request), "") << origin;
  }
  request.origin = std::nullopt;
  for (const char* site : {"cross-site", "same-site", "odd"}) {
    request.fetch_site = site;
    EXPECT_NE(ReasonOf(request), "") << site;
  }
  request.path = "/";  // a link to the page is welcome
  EXPECT_EQ(ReasonOf(request), "");
}

TEST(CheckRequest, OnlyReadsUnlessControlIsAllowed) {
  EXPECT_EQ(ReasonOf(Post(kControlling.token)),
            "403 this page only shows: map_web was started without allow_control");
  EXPECT_EQ(ReasonOf(Post(kControlling.token), kControlling), "");
}

TEST(CheckRequest, ControlTakesTheTokenAndJson) {
  EXPECT_EQ(ReasonOf(Post(""), kControlling).substr(0, 12), "401 no token");
  EXPECT_EQ(ReasonOf(Post("0123456789abcdee"), kControlling).substr(0, 15), "401 wrong token");
  EXPECT_EQ(ReasonOf(Post("0123456789abcde"), kControlling).substr(0, 15), "401 wrong token");
  WebRequest form = Post(kControlling.token);
  form.content_type = "application/x-www-form-urlencoded";
  EXPECT_EQ(ReasonOf(form, kControlling),
            "415 Content-Type 'application/x-www-form-urlencoded': expected application/json");
  form.content_type = "application/json; charset=utf-8";
  EXPECT_EQ(ReasonOf(form, kControlling), "");
}

TEST(CheckRequest, KnowsTwoMethods) {
  WebRequest request = Get("localhost");
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "HEAD", "BREW\n"}) {
    request.method = method;
    EXPECT_EQ(ReasonOf(request).substr(0, 3), "405") << method;
  }
}

TEST(EqualsInConstantTime, IsEquality) {
  EXPECT_TRUE(EqualsInConstantTime("abc", "abc"));
  EXPECT_TRUE(EqualsInConstantTime("", ""));
  for (const char* other : {"", "abd", "ab", "abcd", "abcabc", "Abc"}) {
    EXPECT_FALSE(EqualsInConstantTime(other, "abc")) << other;
    EXPECT_FALSE(EqualsInConstantTime("abc", other)) << other;
  }
}

}  // namespace
}  // namespace rovio_sfm
